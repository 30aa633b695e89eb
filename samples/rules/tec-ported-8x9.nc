%628 "where M37 has a meaning"
"! dialect=cnc8x9
"TEC-8
N10 M37
N20 M36 M71
N40 M30
