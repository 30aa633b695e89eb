%1 "S up to limits.speed, also from a parameter (language.md §2, §11)"
N10 G90 G0 X0 Y0 R1=18000 R2=24001
N20 S18000 M3
N30 S24001
"    ^^^^^ E0302
N40 SR1
N50 SR2
"   ^^^ E0510
N60 M30
