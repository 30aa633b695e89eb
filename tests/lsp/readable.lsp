# Hints at words that are hard to read, in programs that are not executed too; folding by tools.
=== client
{ "locale": "en" }
=== file cnc872c.toml
[operations]
"02" = "sub"
=== open part.nc
‹1›%1
"--- Tool 1 ---"
N10 T1 M06
N20 G0 X1
N30 G04 Q500
"--- Tool 2 ---"
N40 T2 M06
N50 G18 X2 Y,
N55 R14=5 R36=2
N60 G26 R5=02143638
N70 M30‹2›
=== request textDocument/inlayHint part.nc@1..2
=== answer
[
  {
    "label": "= 5 s",
    "paddingLeft": true,
    "position": {
      "character": 12,
      "line": 4
    },
    "tooltip": "The dwell is counted in units of 10 ms: 5 s."
  },
  {
    "label": "YZ",
    "paddingLeft": true,
    "position": {
      "character": 7,
      "line": 7
    },
    "tooltip": "G18 is the plane YZ on this control"
  },
  {
    "label": "R38 = R14 − R36",
    "paddingLeft": true,
    "position": {
      "character": 19,
      "line": 9
    },
    "tooltip": "The block computes R38 = R14 − R36."
  }
]
=== request textDocument/foldingRange part.nc
=== answer
[
  {
    "endLine": 10,
    "kind": "region",
    "startLine": 0
  },
  {
    "endLine": 4,
    "kind": "region",
    "startLine": 2
  },
  {
    "endLine": 10,
    "kind": "region",
    "startLine": 6
  }
]
