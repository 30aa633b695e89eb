%1 "uvozovka pred zavorkou chybi"
N10 T1 (freza)" M06
"      ^^^^^^^ E0101
N20 M30
