%1
N10 g0 X1
N20 M2* the text behind the end of the program stays on its line, whatever is th
