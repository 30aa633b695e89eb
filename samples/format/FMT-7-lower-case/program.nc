%1
n10 g0 g90 x0 y0
n20 g1 x10 f100
n30 m30
