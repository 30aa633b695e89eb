zak. 12
  part %1
n10  g1 X1
N20 M30  *  rest 
 x

