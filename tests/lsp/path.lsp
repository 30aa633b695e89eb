# The path of a program, as the page of `view` has it; of a macrocycle that of the program that calls it.
=== client
{ "locale": "en" }
=== open L9001
N10 G79 L9001
N20 G1 X5 F100
N30 G70
=== request cnc872c/path L9001
=== answer
null
=== open part.nc
%1 "part"
N10 G0 G90 X0 Y0 Z5
N20 G72 L9001
N30 M30
=== request cnc872c/path part.nc
=== answer
{
  "blocks": 6,
  "data": "…",
  "files": [
    "DIR/part.nc",
    "DIR/L9001"
  ],
  "truncated": false,
  "uri": "DIR/part.nc"
}
=== request cnc872c/path L9001
=== answer
{
  "blocks": 6,
  "data": "…",
  "files": [
    "DIR/part.nc",
    "DIR/L9001"
  ],
  "truncated": false,
  "uri": "DIR/part.nc"
}
=== text part.nc
%1 "part"
N10 G0 G90 X0 Y0 Z5
N20 G72
N30 G71 L5
N40 M30
=== request cnc872c/path part.nc
=== answer
{
  "blocks": 0,
  "data": "…",
  "files": [
    "DIR/part.nc"
  ],
  "truncated": false,
  "uri": "DIR/part.nc"
}
=== text part.nc
%1 "part"
N10 G0 G90 X0 Y0 Z5
N20 X0 Y
N30 M30
=== request cnc872c/path part.nc
=== answer
{
  "blocks": 0,
  "data": "…",
  "files": [
    "DIR/part.nc"
  ],
  "truncated": false,
  "uri": "DIR/part.nc"
}
