# Findings come after opening and after every change, also by a macrocycle and the project file.
=== file L9001
N1 G79 L9001
N2 X5,5
N3 G70
=== open part.nc
%1
N10 G72 L9001
N20 G1 X‹1›10.‹2›
N30 M30
=== findings part.nc
2:4-2:6 W0601 working motion before the program sets a feed | help: write `F` in this block or before it; otherwise the feed of the program before stays in force
=== findings L9001
1:3-1:7 E0104 a decimal comma | help: the control knows the decimal point only: write `X5.5`
=== replace part.nc 1 2
ř
=== findings part.nc
2:4-2:6 W0601 working motion before the program sets a feed | help: write `F` in this block or before it; otherwise the feed of the program before stays in force
2:7-2:9 E0101 `Xř` means nothing to the control | help: on a Czech keyboard digits are typed with Shift: if a digit is meant, write `X5`
=== text part.nc
%1
N10 G00 X1
N20 M30
=== findings part.nc
=== open cnc872c.toml
axes = ["Y", "Q"]
=== findings cnc872c.toml
0:8-0:11 E0702 `axes` takes a table
0:13-0:16 E0702 `axes` takes a table
=== request textDocument/diagnostic part.nc
=== close cnc872c.toml
=== findings cnc872c.toml
0:8-0:11 E0702 `axes` takes a table
0:13-0:16 E0702 `axes` takes a table
