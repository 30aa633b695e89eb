%308 "M jedne skupiny v bloku
"MFN-1 two functions of one group
N10 G90 G0 X0 Y0 S800 M3 M4
"                        ^^ E0308
N20 M7 M8
"      ^^ E0308
N30 T2 M6 M60
"         ^^^ E0308
N40 M20 M21
"       ^^^ E0308
N50 M5 M05
"      ^^^ E0308
N60 M41 M42
"       ^^^ E0308
N70 M30 M0
"       ^^ E0308
