# What holds at a place, and a program that starts there.
=== client
{ "locale": "en", "capabilities": { "experimental": { "commands": { "commands": ["cnc872c.stateHere"] } } } }
=== open L9001
N10 G79 L9001
N20 ‹macro›G91 G01 Z-1
N30 G90 G70
=== open part.nc
%1 "‹title›part"
N10 G90 G54 G00 X0 Y0 Z50 R10=2
N20 T5 ‹change›M06
N30 S900 M03 F200
N40 G01 ‹once›X10
N50 G72 L9001 Q2
N60 ‹loop›Y10
N70 G73 L60 Q1
N80 G41 D1 X20
N90 ‹corrected›G40 X30
N95 X40 G73 L99
N97 ‹never›X50
N99 M30
=== request cnc872c/state part.nc@once
=== answer
{
  "seq": 3,
  "state": {
    "counters": [],
    "feed": 200,
    "feed_unit": "mm/min",
    "g": [
      0,
      17,
      98,
      40,
      null,
      54,
      94,
      70,
      80,
      90,
      75,
      34
    ],
    "generator": "cnc872c 0.2.0",
    "kind": "state",
    "m": [
      null,
      null,
      3,
      40,
      null,
      9,
      53,
      null,
      48,
      null,
      null,
      null,
      null,
      null,
      null
    ],
    "name": "part.nc",
    "parameters": {
      "R10": 2
    },
    "place": {
      "after": false,
      "calls": [],
      "column": 1,
      "file": 0,
      "line": 5,
      "n": 40,
      "seq": 3
    },
    "position": {
      "X": 0,
      "Y": 0,
      "Z": 50
    },
    "progress": {
      "blocks": 3,
      "blocks_left": 16,
      "lower_bound": true,
      "path_left_mm": 52,
      "path_mm": 0,
      "time_left_s": 15.646667,
      "time_s": 0
    },
    "s": 900,
    "schema": "cnc872c.state/1",
    "t": 5,
    "tool": 5,
    "unknown": {},
    "written": {
      "R10": {
        "file": 0,
        "line": 2,
        "n": 10,
        "seq": 0
      },
      "X": {
        "file": 0,
        "line": 2,
        "n": 10,
        "seq": 0
      },
      "Y": {
        "file": 0,
        "line": 2,
        "n": 10,
        "seq": 0
      },
      "Z": {
        "file": 0,
        "line": 2,
        "n": 10,
        "seq": 0
      },
      "feed": {
        "file": 0,
        "line": 4,
        "n": 30,
        "seq": 2
      },
      "g0": {
        "file": 0,
        "line": 2,
        "n": 10,
        "seq": 0
      },
      "g5": {
        "file": 0,
        "line": 2,
        "n": 10,
        "seq": 0
      },
      "g9": {
        "file": 0,
        "line": 2,
        "n": 10,
        "seq": 0
      },
      "m2": {
        "file": 0,
        "line": 4,
        "n": 30,
        "seq": 2
      },
      "s": {
        "file": 0,
        "line": 4,
        "n": 30,
        "seq": 2
      },
      "t": {
        "file": 0,
        "line": 3,
        "n": 20,
        "seq": 1
      },
      "tool": {
        "file": 0,
        "line": 3,
        "n": 20,
        "seq": 1
      }
    }
  },
  "text": "Before N40 (line 5, seq 3) of part.nc\n\nPosition\n  X  0   N10 (line 2)\n  Y  0   N10 (line 2)\n  Z  50  N10 (line 2)\n\nG functions\n  G00  rapid traverse                                    N10 (line 2)\n  G17  plane XY                                          since power-up\n  G98  basic state of the group: blocks join with ramps  since power-up\n  G40  radius correction off                             since power-up\n  G54  zero offset 1                                     N10 (line 2)\n  G94  feed per minute                                   since power-up\n  G70  end of a subprogram or macrocycle                 since power-up\n  G80  no fixed cycle                                    since power-up\n  G90  absolute coordinates                              N10 (line 2)\n  G75  radius programming                                since power-up\n  G34  all conversions of coordinates off                since power-up\n\nM functions\n  M03  spindle on, clockwise         N30 (line 4)\n  M40  spindle range follows from S  since power-up\n  M09  coolant 1 and 2 off           since power-up\n  M53  coolant 3 and 4 off           since power-up\n  M48  feed override works           since power-up\n\nValues\n  F               200 mm/min  N30 (line 4)\n  S               900         N30 (line 4)\n  T               5           N20 (line 3)\n  in the spindle  T5          N20 (line 3)\n\nParameters\n  R10  2  N10 (line 2)\n\nProgress\n            done       left       done, this tool  left, this tool\n  blocks    3          16         2                16\n  path, mm  0          52         0                52\n  time      0:00:00.0  0:00:15.6  0:00:00.0        0:00:15.6\n  times and paths are at least these: some are not known\n"
}
=== request cnc872c/restart part.nc@once
{ "after": true, "safe": "60" }
=== answer
{
  "message": null,
  "name": "part-N50.nc",
  "text": "%1 \"part.nc from N50\"\nN100 G54 \"functions in force\"\nN110 T5 M06 \"tool change, N20\"\nN120 S900 M03 \"spindle, N30\"\nN130 F200 \"feed, N30\"\nN140 G00 G90 Z60 \"up to --safe\"\nN150 G00 X10 Y0 \"across\"\nN160 G00 Z52 \"down to 2 mm above the place\"\nN170 G01 Z50 \"to the place at F\"\nN50 G72 L9001 Q2\nN60 Y10\nN70 G73 L60 Q1\nN80 G41 D1 X20\nN90 G40 X30\nN95 X40 G73 L99\nN97 X50\nN99 M30\n"
}
=== request cnc872c/state part.nc@title
=== answer
null
=== request cnc872c/state part.nc@loop
=== answer
{
  "count": 2,
  "message": "N60 is executed 2 times: which execution?",
  "passes": [
    {
      "pass": 1,
      "seq": 11,
      "text": "N60, line 7, seq 11, in the main program"
    },
    {
      "pass": 2,
      "seq": 13,
      "text": "N60, line 7, seq 13, in the main program"
    }
  ]
}
=== request cnc872c/state part.nc@loop
{ "seq": 11, "after": true }
=== answer
{
  "seq": 11,
  "state": {
    "counters": [],
    "feed": 200,
    "feed_unit": "mm/min",
    "g": [
      1,
      17,
      98,
      40,
      null,
      54,
      94,
      70,
      80,
      90,
      75,
      34
    ],
    "generator": "cnc872c 0.2.0",
    "kind": "state",
    "m": [
      null,
      null,
      3,
      40,
      null,
      9,
      53,
      null,
      48,
      null,
      null,
      null,
      null,
      null,
      null
    ],
    "name": "part.nc",
    "parameters": {
      "R10": 2
    },
    "place": {
      "after": true,
      "calls": [],
      "column": 1,
      "file": 0,
      "line": 7,
      "n": 60,
      "seq": 11
    },
    "position": {
      "X": 10,
      "Y": 10,
      "Z": 48
    },
    "progress": {
      "blocks": 12,
      "blocks_left": 7,
      "lower_bound": true,
      "path_left_mm": 30,
      "path_mm": 22,
      "time_left_s": 9.02,
      "time_s": 6.626667
    },
    "s": 900,
    "schema": "cnc872c.state/1",
    "t": 5,
    "tool": 5,
    "unknown": {},
    "written": {
      "R10": {
        "file": 0,
        "line": 2,
        "n": 10,
        "seq": 0
      },
      "X": {
        "file": 0,
        "line": 5,
        "n": 40,
        "seq": 3
      },
      "Y": {
        "file": 0,
        "line": 7,
        "n": 60,
        "seq": 11
      },
      "Z": {
        "file": 1,
        "line": 2,
        "n": 20,
        "seq": 9
      },
      "feed": {
        "file": 0,
        "line": 4,
        "n": 30,
        "seq": 2
      },
      "g0": {
        "file": 1,
        "line": 2,
        "n": 20,
        "seq": 9
      },
      "g5": {
        "file": 0,
        "line": 2,
        "n": 10,
        "seq": 0
      },
      "g7": {
        "file": 1,
        "line": 3,
        "n": 30,
        "seq": 10
      },
      "g9": {
        "file": 1,
        "line": 3,
        "n": 30,
        "seq": 10
      },
      "m2": {
        "file": 0,
        "line": 4,
        "n": 30,
        "seq": 2
      },
      "s": {
        "file": 0,
        "line": 4,
        "n": 30,
        "seq": 2
      },
      "t": {
        "file": 0,
        "line": 3,
        "n": 20,
        "seq": 1
      },
      "tool": {
        "file": 0,
        "line": 3,
        "n": 20,
        "seq": 1
      }
    }
  },
  "text": "Behind N60 (line 7, seq 11) of part.nc\n\nPosition\n  X  10  N40 (line 5)\n  Y  10  N60 (line 7)\n  Z  48  N20 (line 2) in L9001\n\nG functions\n  G01  linear interpolation                              N20 (line 2) in L9001\n  G17  plane XY                                          since power-up\n  G98  basic state of the group: blocks join with ramps  since power-up\n  G40  radius correction off                             since power-up\n  G54  zero offset 1                                     N10 (line 2)\n  G94  feed per minute                                   since power-up\n  G70  end of a subprogram or macrocycle                 N30 (line 3) in L9001\n  G80  no fixed cycle                                    since power-up\n  G90  absolute coordinates                              N30 (line 3) in L9001\n  G75  radius programming                                since power-up\n  G34  all conversions of coordinates off                since power-up\n\nM functions\n  M03  spindle on, clockwise         N30 (line 4)\n  M40  spindle range follows from S  since power-up\n  M09  coolant 1 and 2 off           since power-up\n  M53  coolant 3 and 4 off           since power-up\n  M48  feed override works           since power-up\n\nValues\n  F               200 mm/min  N30 (line 4)\n  S               900         N30 (line 4)\n  T               5           N20 (line 3)\n  in the spindle  T5          N20 (line 3)\n\nParameters\n  R10  2  N10 (line 2)\n\nProgress\n            done       left       done, this tool  left, this tool\n  blocks    12         7          11               7\n  path, mm  22         30         22               30\n  time      0:00:06.6  0:00:09.0  0:00:06.6        0:00:09.0\n  times and paths are at least these: some are not known\n"
}
=== request cnc872c/state L9001@macro
=== answer
{
  "count": 2,
  "message": "N20 is executed 2 times: which execution?",
  "passes": [
    {
      "pass": 1,
      "seq": 6,
      "text": "N20, line 2, seq 6, L9001 from N50 (1/2)"
    },
    {
      "pass": 2,
      "seq": 9,
      "text": "N20, line 2, seq 9, L9001 from N50 (2/2)"
    }
  ]
}
=== request cnc872c/state part.nc@never
=== answer
{
  "code": -32803,
  "message": "N97 is never executed"
}
=== request cnc872c/restart part.nc@once
=== answer
{
  "safe": "--safe is missing: with this tool and origin the program shows no height in Z to move across at"
}
=== request cnc872c/restart part.nc@corrected
=== answer
{
  "nearest": {
    "n": 10,
    "seq": 0
  },
  "refused": "no start there: G41 is in force: only the program itself can lead the tool to the corrected path\nnearest earlier place that works: --seq 0, N10 (line 2), 0:00:00.0 after program start"
}
=== request cnc872c/restart part.nc@loop
{ "seq": 11, "safe": "60" }
=== answer
{
  "message": null,
  "name": "part-N60.nc",
  "text": "%1 \"part.nc from N60, pass 1\"\nN100 G54 \"functions in force\"\nN110 T5 M06 \"tool change, N20\"\nN120 S900 M03 \"spindle, N30\"\nN130 F200 \"feed, N30\"\nN140 G00 G90 Z60 \"up to --safe\"\nN150 G00 X10 Y0 \"across\"\nN160 G00 Z50 \"down to 2 mm above the place\"\nN170 G01 Z48 \"to the place at F\"\nN60 Y10\nN70 G73 L60 Q1\nN80 G41 D1 X20\nN90 G40 X30\nN95 X40 G73 L99\nN97 X50\nN99 M30\n"
}
=== request cnc872c/restart part.nc@loop
{ "seq": 11 }
=== answer
{
  "safe": "--safe is missing: with this tool and origin the program shows no height in Z to move across at"
}
=== request textDocument/codeLens part.nc
=== answer
[
  {
    "command": {
      "command": "",
      "title": "executed blocks: 19, path 52 mm"
    },
    "range": {
      "end": {
        "character": 2,
        "line": 0
      },
      "start": {
        "character": 0,
        "line": 0
      }
    }
  },
  {
    "command": {
      "arguments": [
        "DIR/part.nc",
        {
          "character": 0,
          "line": 2
        }
      ],
      "command": "cnc872c.stateHere",
      "title": "state here"
    },
    "range": {
      "end": {
        "character": 3,
        "line": 2
      },
      "start": {
        "character": 0,
        "line": 2
      }
    }
  }
]
=== open flat.nc
%2
N10 G90 G01 X0 Z5 F100
N20 ‹flat›X10
N30 M30
=== request cnc872c/restart flat.nc@flat
=== answer
{
  "safe": "--safe is missing: with this tool and origin the program shows no height in Z to move across at"
}
=== request cnc872c/restart flat.nc@flat
{ "safe": "50,5" }
=== answer
{
  "message": null,
  "name": "flat-N20.nc",
  "text": "%2 \"flat.nc from N20\"\nN40 F100 \"feed, N10\"\nN50 G00 G90 Z50.5 \"up to --safe\"\nN60 G00 X0 \"across\"\nN70 G00 Z7 \"down to 2 mm above the place\"\nN80 G01 Z5 \"to the place at F\"\nN20 X10\nN30 M30\n"
}
=== request cnc872c/restart flat.nc@flat
{ "safe": "high" }
=== answer
{
  "code": -32803,
  "message": "high is no height in mm with at most three decimals"
}
=== text part.nc
%1
N10 G73 L99
N20 X1 X2
N30 ‹once›M30
=== request cnc872c/state part.nc@once
=== answer
{
  "code": -32803,
  "message": "the program has errors before this block: what holds here is not known"
}
=== request cnc872c/restart part.nc@once
=== answer
{
  "code": -32803,
  "message": "the program cannot be compiled; errors: 2, the first: part.nc, line 2: there is no block N99 to jump to"
}
