%1 "uvozovky na zacatku radku s poznamkou chybi"
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3
N40 G1 Z-2 F300
N50 X5
--- kontura 2: drazka hloubky 3 od mista Z0 ---"
"@ 7:1-7:48 E0111
N80 G0 Z50
N90 M30
