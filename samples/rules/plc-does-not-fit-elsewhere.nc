%1 "PLC-7 only for bytes among the chosen signals"
"! plc=PB06,BLK.M[14],BLK.H
N10 G0 G90 X0 Y0 H100 M100
N20 M30
