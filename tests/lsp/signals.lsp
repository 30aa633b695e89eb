# What the PLC reads in the block at a place.
=== client
{ "locale": "en" }
=== file cnc872c.toml
dialect = "cnc8x6"
=== open L9001
N10 G79 L9001
N20 ‹macro›M10
N30 G70
=== open part.nc
%1 "‹title›part"
N10 G00 G90 X1 ‹first›Y1
N20 S900 ‹start›M03 "spindle"
N30 G72 L9001
N40 G73 L30 Q2
N50 ‹stop›M00
N60 M30
=== request cnc872c/signals part.nc@start
=== answer
{
  "text": "N20 S900 M03 \"spindle\"\nN20 runs 1×\n\nseq 1\n  changes in this block:\n    ZMM2PI=1                change bit of M group 2\n    PO_OSXPI=0              request to move axis X: X\n    PO_OSYPI=0              request to move axis Y: Y\n    PB06=03h                the function of M group 2: the spindle\n    M03PI=1                 M03 in force: spindle clockwise\n  in force besides:\n    G00PI=1                 rapid traverse (G00)\n    AUTPI=1                 automatic mode\n",
  "truncated": false
}
=== request cnc872c/signals part.nc@first
=== answer
{
  "text": "N10 G00 G90 X1 Y1\nN10 runs 1×\n\nseq 0\n  changes in this block:\n    PO_OSXPI=1              request to move axis X: X\n    PO_OSYPI=1              request to move axis Y: Y\n    PB06=05h                the function of M group 2: the spindle\n    G00PI=1                 rapid traverse (G00)\n    AUTPI=1                 automatic mode\n",
  "truncated": false
}
=== request cnc872c/signals part.nc@stop
=== answer
{
  "text": "N50 M00\nN50 runs 1×\n\nseq 17\n  changes in this block:\n    ZMM1PI=1                change bit of M group 1\n    M00_PID=1               M00 is programmed: stop\n  in force besides:\n    PB06=03h                the function of M group 2: the spindle\n    M03PI=1                 M03 in force: spindle clockwise\n    G00PI=1                 rapid traverse (G00)\n    AUTPI=1                 automatic mode\n\nseq 17, stop\n  changes in this block:\n    ZMM1PI=0                change bit of M group 1\n    ZMM2PI=1                change bit of M group 2\n    ZMM5PI=1                change bit of M group 5\n    ZMM6PI=1                change bit of M group 6\n    PB06=05h                the function of M group 2: the spindle\n    M00_PID=0               M00 is programmed: stop\n    M03PI=0                 M03 in force: spindle clockwise\n    SF_STOP=1               the program stands at M00 or M01\n    PO_STOP=1               the program stands at M00 or M01\n  in force besides:\n    G00PI=1                 rapid traverse (G00)\n    AUTPI=1                 automatic mode\n",
  "truncated": false
}
=== request cnc872c/signals L9001@macro
=== answer
{
  "text": "N20 M10\nN20 runs 3×\n\nseq 4 (3×)\n  changes in this block:\n    ZMM7PI=1                change bit of M group 7\n    M10PID=1                M10 is programmed: clamp the workpiece\n  in force besides:\n    PB06=03h                the function of M group 2: the spindle\n    M03PI=1                 M03 in force: spindle clockwise\n    G00PI=1                 rapid traverse (G00)\n    AUTPI=1                 automatic mode\n",
  "truncated": false
}
=== request cnc872c/signals part.nc@title
=== answer
null
=== text part.nc
%1
N10 G73 L99
N20 M30
=== request cnc872c/signals part.nc@first
=== answer
{
  "text": "N10 G73 L99\nN10 runs 1×\n\nseq 0\n  changes in this block:\n    PB06=05h                the function of M group 2: the spindle\n    G00PI=1                 rapid traverse (G00)\n    AUTPI=1                 automatic mode\n",
  "truncated": false
}
=== request cnc872c/signals L9001@macro
=== answer
{
  "code": -32803,
  "message": "no open program calls this macrocycle: nothing is known of its execution"
}
