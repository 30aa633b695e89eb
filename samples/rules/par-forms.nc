%40 "PAR-1 PAR-2 assignments and uses
N10 R10=25.5 R11 = 3 R12 7.5 R13-5 R14 -2 R15+4 R16 =1 R17= 2
N20 R20=R10 R21=-R11 R22 = R12 R0=0 R94=1.
N30 G90 G0 XR10 Y R10 Z-R10
N40 X+R10 Y -R12 Z R15
N50 /R30=5 "the slash has no value: this assigns"
N60 XR30
N70 XR10R31=5 "X is R10, R31 is 5"
N80 R32=R10R33=4
N90 XR31 YR32 ZR33
N100 X5R34=6Y7 "assignments and words in a row"
N110 XR34
N120 R0010=4 "leading zeros of the parameter number
N130 M30
