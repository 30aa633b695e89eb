%1
n10  x1
N20 X- 5
  y7
N30  g1 N40  ?
  x5
N50  m30
