# What an open program does otherwise than its saved text, and than another file; CMP-1.
=== client
{ "locale": "en" }
=== file part.nc
%1 "part"
N10 G90 G0 X0 Y0 Z5 T1 M06
N20 S1000 M3
N30 G1 Z-1 F200
N40 X50
N50 M30
=== file new.nc
%1 "part"
N1 G90 G0 X0 Y0 Z5 T1 M06
N2 S1000 M3
N3 G01 Z-1. F250
N4 X50
N5 M30
=== open part.nc
%1 "part"
N10 G90 G0 X0 Y0 Z5 T1 M06
N20 S1000 M3
N30 G1 Z-1.2 F200
N40 X50
N50 M30
=== request cnc872c/compare part.nc
=== answer
{
  "same": false,
  "text": "part.nc → part.nc\nblocks 5 → 5\ntime 0:00:16.8 → 0:00:16.9 (+0.1 s)\nT1: Z −0.2 in 1 block (N30)\n"
}
=== request cnc872c/compare part.nc
{ "with": "DIR/new.nc" }
=== answer
{
  "same": false,
  "text": "new.nc → part.nc\nblocks 5 → 5\ntime 0:00:13.5 → 0:00:16.9 (+3.4 s)\nT1: changes 2, in blocks 2\nT1: Z −0.2 in 1 block (N30, was N3)\nT1: F 250 → 200 in 2 blocks (N30–N40, was N3–N4)\n"
}
=== request cnc872c/compare part.nc
{ "page": true }
=== answer
{
  "page": "…",
  "same": false,
  "text": "part.nc → part.nc\nblocks 5 → 5\ntime 0:00:16.8 → 0:00:16.9 (+0.1 s)\nT1: Z −0.2 in 1 block (N30)\n"
}
=== request cnc872c/compare part.nc
{ "with": "DIR/none.nc" }
=== answer
{
  "code": -32803,
  "message": "none.nc cannot be read"
}
=== text part.nc
%1 "part"
N10 G90 G0 X0 Y0 Z5
N20 G71 L5
N50 M30
=== request cnc872c/compare part.nc
=== answer
{
  "code": -32803,
  "message": "part.nc has errors: it cannot be compared"
}
=== request cnc872c/compare part.nc
{ "with": 5 }
=== answer
{
  "code": -32602,
  "message": "invalid type: integer `5`, expected a string representing an URL"
}
