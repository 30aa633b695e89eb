%1
N20 G1 X1111.111 Y2222.222 "drazka pro pero 8P9, kontrolovat kalibrem po kazdem kusu"
N30 M30
