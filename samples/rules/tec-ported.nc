%627 "M37 on CNC872 without a ChannelConfig"
"TEC-8 other functions of group 14 are the machine's own
N10 M71
N20 M37
"   ^^^ W0623
N30 M37
N40 M30
