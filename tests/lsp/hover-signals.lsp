# What a word sets for the PLC, as the execution of its block shows: the gear under M40, the end of the program, a stop.
=== client
{ "locale": "en", "capabilities": { "textDocument": { "hover": { "contentFormat": ["plaintext"] } } } }
=== file cnc872c.toml
dialect = "cnc872"
[[gears]]
m = 41
min = 0
max = 1000
[[gears]]
m = 42
min = 1001
max = 4000
=== open part.nc
%1 "part"
N10 G00 G90 X0 ‹M40›M40 S500 M08
N20 X5 ‹S›S1500 ‹M03›M03
N30 X6 ‹M00›M00
N40 R10=3 S900
N50 X7 ‹loop›S1200
N60 S900 G73 L50 Q2
N70 ‹M30›M30
=== request textDocument/hover part.nc@M40
=== answer
{
  "contents": {
    "kind": "plaintext",
    "value": "M40: spindle range follows from S\ngroup 3 of the M functions; holds until another function of its group; also after power-up, M02 and M30\nthe PLC reads: BLK.M[3]=40h BLK.M3=1 ZMM3PI=1 PB11=00h PB12=40h M41PI=1 M42PI=0 M43PI=0 M44PI=0 SPINDLE_GEAR_ACT_1=1\n\nN10 runs 1×\nposition after the block: X 0 mm\nlength of the motion: unknown\nG functions in force: G00 G17 G98 G40 G53 G94 G80 G90 G75 G34\nM functions after the block: M05 M40 M08 M53 M48\ntechnology: S 500 rev/min"
  },
  "range": {
    "end": {
      "character": 18,
      "line": 1
    },
    "start": {
      "character": 15,
      "line": 1
    }
  }
}
=== request textDocument/hover part.nc@S
=== answer
{
  "contents": {
    "kind": "plaintext",
    "value": "S 1500 rev/min: spindle speed in rev/min\nholds until changed\nthe PLC reads: BLK.M3=1 BLK.SpindleSpeed=1500 ZMM3PI=1 PB11=00h PB12=30h M41PI=0 M42PI=1 M43PI=0 M44PI=0 SPINDLE_GEAR_ACT_1=2\n\nN20 runs 1×\nposition after the block: X 5 mm\nlength of the motion: 5 mm\nG functions in force: G00 G17 G98 G40 G53 G94 G80 G90 G75 G34\nM functions after the block: M03 M40 M08 M53 M48\ntechnology: S 1500 rev/min"
  },
  "range": {
    "end": {
      "character": 12,
      "line": 2
    },
    "start": {
      "character": 7,
      "line": 2
    }
  }
}
=== request textDocument/hover part.nc@M03
=== answer
{
  "contents": {
    "kind": "plaintext",
    "value": "M03: spindle on, clockwise\ngroup 2 of the M functions; holds until another function of its group\nthe PLC reads: BLK.M[2]=03h BLK.M2=1 ZMM2PI=1 PB06=03h M03PI=1 M04PI=0 M19PI=0\n\nN20 runs 1×\nposition after the block: X 5 mm\nlength of the motion: 5 mm\nG functions in force: G00 G17 G98 G40 G53 G94 G80 G90 G75 G34\nM functions after the block: M03 M40 M08 M53 M48\ntechnology: S 1500 rev/min"
  },
  "range": {
    "end": {
      "character": 16,
      "line": 2
    },
    "start": {
      "character": 13,
      "line": 2
    }
  }
}
=== request textDocument/hover part.nc@M00
=== answer
{
  "contents": {
    "kind": "plaintext",
    "value": "M00: program stop\ngroup 1 of the M functions; holds in its block only\nthe PLC reads: BLK.M[1]=00h BLK.M1=1 BLK.Stop=1 ZMM1PI=1 M00_PID=1\nwhile the program stands: BLK.M[1]=- BLK.M[2]=05h BLK.M[5]=09h BLK.M1=0 BLK.M2=1 BLK.M5=1 BLK.M6=1 BLK.Stop=0 ZMM1PI=0 ZMM2PI=1 ZMM5PI=1 ZMM6PI=1 PB06=05h M00_PID=0 M03PI=0 M08PI=0\n\nN30 runs 1×\nposition after the block: X 6 mm\nlength of the motion: 1 mm\nG functions in force: G00 G17 G98 G40 G53 G94 G80 G90 G75 G34\nM functions after the block: M00 M03 M40 M08 M53 M48\ntechnology: S 1500 rev/min"
  },
  "range": {
    "end": {
      "character": 10,
      "line": 3
    },
    "start": {
      "character": 7,
      "line": 3
    }
  }
}
=== request textDocument/hover part.nc@loop
=== answer
{
  "contents": {
    "kind": "plaintext",
    "value": "S 1200 rev/min: spindle speed in rev/min\nholds until changed\nthe PLC reads: BLK.M3=1 BLK.SpindleSpeed=1200 ZMM3PI=1 PB11=66h PB12=26h M41PI=0 M42PI=1 M43PI=0 M44PI=0 SPINDLE_GEAR_ACT_1=2\n\nN50 runs 3×\nposition after the block: X 7 mm\nlength of the motion: 1, 0 mm\nG functions in force: G00 G17 G98 G40 G53 G94 G80 G90 G75 G34\nM functions after the block: M03 M40 M08 M53 M48\ntechnology: S 1200 rev/min"
  },
  "range": {
    "end": {
      "character": 12,
      "line": 5
    },
    "start": {
      "character": 7,
      "line": 5
    }
  }
}
=== request textDocument/hover part.nc@M30
=== answer
{
  "contents": {
    "kind": "plaintext",
    "value": "M30: end of program\ngroup 1 of the M functions; holds in its block only\nthe PLC reads: BLK.M[1]=30h BLK.M[2]=05h BLK.M[5]=09h BLK.M[6]=53h BLK.M1=1 BLK.M2=1 BLK.M5=1 BLK.M6=1 BLK.LastBlock=1 ZMM1PI=1 ZMM2PI=1 ZMM5PI=1 ZMM6PI=1 PB06=05h M30_PID=1 M03PI=0 M04PI=0 M19PI=0 M07PI=0 M08PI=0 M50PI=0 M51PI=0\n\nN70 runs 1×\nposition after the block: X 7 mm\nG functions in force: G00 G17 G98 G40 G53 G94 G80 G90 G75 G34\nM functions after the block: M30 M05 M40 M09 M53 M48\ntechnology: S 900 rev/min"
  },
  "range": {
    "end": {
      "character": 7,
      "line": 7
    },
    "start": {
      "character": 4,
      "line": 7
    }
  }
}
=== request cnc872c/signals part.nc@M00
=== answer
{
  "text": "N30 X6 M00\nN30 runs 1×\n\nseq 2\n  changes in this block:\n    BLK.M[1]=00h            the function of M group 1\n    BLK.M1=1                change bit of M group 1\n    BLK.M2=0                change bit of M group 2\n    BLK.M3=0                change bit of M group 3\n    BLK.Stop=1              M00 is programmed in the block\n    BLK.AxNC[0]=6           programmed position of NC axis 0 after the block [mm, deg]: X\n    BLK.BlockLen=1          length of the block [mm, deg]\n    ZMM1PI=1                change bit of M group 1\n    ZMM2PI=0                change bit of M group 2\n    ZMM3PI=0                change bit of M group 3\n    M00_PID=1               M00 is programmed: stop\n  in force besides:\n    BLK.M[2]=03h            the function of M group 2\n    BLK.M[3]=40h            the function of M group 3\n    BLK.M[5]=08h            the function of M group 5\n    BLK.M[6]=53h            the function of M group 6\n    BLK.M[8]=48h            the function of M group 8\n    BLK.AxNC0Move=1         NC axis 0 moves in the block: X\n    BLK.SpindleSpeed=1500   spindle speed [rev/min]\n    PO_OSXPI=1              request to move axis X: X\n    PB06=03h                the function of M group 2: the spindle\n    PB11=00h                output for the programmed spindle speed, low byte\n    PB12=30h                output for the programmed spindle speed, high byte\n    M03PI=1                 M03 in force: spindle clockwise\n    M42PI=1                 spindle range 2\n    M08PI=1                 M08 or M17 in force\n    G00PI=1                 rapid traverse (G00)\n    AUTPI=1                 automatic mode\n    SPINDLE_GEAR_ACT_1=2    spindle gear in force, 1 to 4\n\nseq 2, stop\n  changes in this block:\n    BLK.M[1]=-              the function of M group 1\n    BLK.M[2]=05h            the function of M group 2\n    BLK.M[5]=09h            the function of M group 5\n    BLK.M1=0                change bit of M group 1\n    BLK.M2=1                change bit of M group 2\n    BLK.M5=1                change bit of M group 5\n    BLK.M6=1                change bit of M group 6\n    BLK.Stop=0              M00 is programmed in the block\n    BLK.AxNC0Move=0         NC axis 0 moves in the block: X\n    BLK.BlockLen=-          length of the block [mm, deg]\n    ZMM1PI=0                change bit of M group 1\n    ZMM2PI=1                change bit of M group 2\n    ZMM5PI=1                change bit of M group 5\n    ZMM6PI=1                change bit of M group 6\n    PO_OSXPI=0              request to move axis X: X\n    SM_POXPI=-              direction of axis X: 1 is negative: X\n    PB06=05h                the function of M group 2: the spindle\n    M00_PID=0               M00 is programmed: stop\n    M03PI=0                 M03 in force: spindle clockwise\n    M08PI=0                 M08 or M17 in force\n    SF_STOP=1               the program stands at M00 or M01\n    PO_STOP=1               the program stands at M00 or M01\n  in force besides:\n    BLK.M[3]=40h            the function of M group 3\n    BLK.M[6]=53h            the function of M group 6\n    BLK.M[8]=48h            the function of M group 8\n    BLK.AxNC[0]=6           programmed position of NC axis 0 after the block [mm, deg]: X\n    BLK.SpindleSpeed=1500   spindle speed [rev/min]\n    PB11=00h                output for the programmed spindle speed, low byte\n    PB12=30h                output for the programmed spindle speed, high byte\n    M42PI=1                 spindle range 2\n    G00PI=1                 rapid traverse (G00)\n    AUTPI=1                 automatic mode\n    SPINDLE_GEAR_ACT_1=2    spindle gear in force, 1 to 4\n",
  "truncated": false
}
=== request cnc872c/signals part.nc@M30
=== answer
{
  "text": "N70 M30\nN70 runs 1×\n\nseq 10\n  changes in this block:\n    BLK.M[1]=30h            the function of M group 1\n    BLK.M[2]=05h            the function of M group 2\n    BLK.M[5]=09h            the function of M group 5\n    BLK.M1=1                change bit of M group 1\n    BLK.M2=1                change bit of M group 2\n    BLK.M3=0                change bit of M group 3\n    BLK.M5=1                change bit of M group 5\n    BLK.M6=1                change bit of M group 6\n    BLK.LastBlock=1         last block of the program\n    ZMM1PI=1                change bit of M group 1\n    ZMM2PI=1                change bit of M group 2\n    ZMM3PI=0                change bit of M group 3\n    ZMM5PI=1                change bit of M group 5\n    ZMM6PI=1                change bit of M group 6\n    PB06=05h                the function of M group 2: the spindle\n    M30_PID=1               M30 is programmed: end of program\n    M03PI=0                 M03 in force: spindle clockwise\n    M08PI=0                 M08 or M17 in force\n  in force besides:\n    BLK.M[3]=40h            the function of M group 3\n    BLK.M[6]=53h            the function of M group 6\n    BLK.M[8]=48h            the function of M group 8\n    BLK.AxNC[0]=7           programmed position of NC axis 0 after the block [mm, deg]: X\n    BLK.SpindleSpeed=900    spindle speed [rev/min]\n    PB11=32h                output for the programmed spindle speed, low byte\n    PB12=73h                output for the programmed spindle speed, high byte\n    M41PI=1                 spindle range 1\n    G00PI=1                 rapid traverse (G00)\n    AUTPI=1                 automatic mode\n    SPINDLE_GEAR_ACT_1=1    spindle gear in force, 1 to 4\n",
  "truncated": false
}
