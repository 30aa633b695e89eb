%1021 "LEX-11 lower-case addresses mean the same; one warning
N10 G90 G0 X0 Y0 R10=5
N20 xr10
"   ^ W0108
n30 g71l100 "LEX-12 an l after a digit is the address L"
N40 m30
n100 g79 l100
n110 g1 y5 f100
n120 g70
