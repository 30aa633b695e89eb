%607 "Otacky mimo prevodovy stupen
"MFN-9 with M41 to M44 the gear table holds
N10 G90 G0 X0 Y0
N20 M41 S800 M3
"       ^^^^ E0607
N30 S300
N40 M42
"   ^^^ E0607
N50 S399
"   ^^^^ E0607
N60 S400
N70 M40 S3000
"       ^^^^^ W0617
N80 M30
