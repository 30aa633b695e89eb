%626 "functions that the ChannelConfig does not define"
"TEC-8 each once, executed or not; M37 is defined there, M36 is not
N10 M71
N20 M72
"   ^^^ W0623
N30 M72 M37
N40 M36
"   ^^^ W0623
N50 M30
