# A project file on the disk has errors from the beginning: programs are checked with what can be read of it, and the client says so.
=== file cnc872c.toml
dialect = "cnc8x6"
[lints]
W0214 = "maybe"
=== open part.nc
%1
N10
N20 G01 X1.5.2
N30 M30
=== findings part.nc
1:0-1:3 W0214 block N10 is empty | help: delete it, or say in a comment what it is for
2:4-2:7 W0601 working motion before the program sets a feed | help: write `F` in this block or before it; otherwise the feed of the program before stays in force
2:8-2:14 E0106 `X1.5.2` is not a valid number | help: a number has at most one sign, digits, and at most one decimal point: `X-12.5`; each number follows its own address
=== said window/showMessage
{
  "message": "the configuration has errors; programs are checked with the default settings",
  "type": 2
}
