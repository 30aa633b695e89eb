# How often stretches run and units are called, and what parameters hold where they are read.
=== client
{ "capabilities": { "workspace": { "inlayHint": { "refreshSupport": true } } } }
=== open L9001
‹1›N1 G79 L9001 "groove"
N2 G91 G01 X‹a›R1‹b› F1000 R1=R2
N3 G70
‹2›
=== open part.nc
‹1›%14
N10 G90 G0 X0 Y0 Z5 R1=5 R2=7.5 R10=-2
N20 G71 L10
N30 G91 X-R10 G73 L20 Q3
N40 Y15 R10=R1
N50 G73 L20 Q2
N60 G73 L80 Q1
N70 G73 L60
‹2›N80 G72 L9001 Q2
N90 XR50
N100 M30
N500 G79 L10
N510 G90 G01 Z-0.8 F120
N520 G00 Z1 G73 L510 Q1
N530 Z5 G70
N600 G79 L20
N610 G70
‹3›
=== said workspace/inlayHint/refresh
null
=== findings part.nc
9:4-9:8 W0503 R50 is read before the program gives it a value | note: its value comes from the machine's parameter table: what depends on it is not checked | help: assign it first: `R50=…`, or give the machine's value with `--param R50=…`
15:5-15:8 W0211 no G71 calls subprogram L20 | help: call it with `G71 L20`, or delete it
=== request textDocument/inlayHint part.nc@1..2
=== answer
[
  {
    "label": "= 2, -5",
    "paddingLeft": true,
    "position": {
      "character": 13,
      "line": 3
    },
    "tooltip": "R10 before the block: -2, 5"
  },
  {
    "label": "×4",
    "paddingLeft": true,
    "position": {
      "character": 24,
      "line": 3
    },
    "tooltip": "N20–N30 run 4× in a row each time they are reached: Q counts the jumps, not the runs. In the whole program the jump is taken 9×."
  },
  {
    "label": "= 5",
    "paddingLeft": true,
    "position": {
      "character": 14,
      "line": 4
    },
    "tooltip": "R1 before the block: 5"
  },
  {
    "label": "×3",
    "paddingLeft": true,
    "position": {
      "character": 14,
      "line": 5
    },
    "tooltip": "N20–N50 run 3× in a row each time they are reached: Q counts the jumps, not the runs. In the whole program the jump is taken 2×."
  },
  {
    "label": "×1",
    "paddingLeft": true,
    "position": {
      "character": 14,
      "line": 6
    },
    "tooltip": "Taken 1× before execution goes on with the next block. In the whole program it is taken 1×."
  }
]
=== request textDocument/inlayHint part.nc@2..3
=== answer
[
  {
    "label": "called 12×",
    "paddingLeft": true,
    "position": {
      "character": 12,
      "line": 11
    },
    "tooltip": "How often it is executed in the whole program; every repeat by Q counts."
  },
  {
    "label": "×2",
    "paddingLeft": true,
    "position": {
      "character": 23,
      "line": 13
    },
    "tooltip": "N510–N520 run 2× in a row each time they are reached: Q counts the jumps, not the runs. In the whole program the jump is taken 12×."
  },
  {
    "label": "called 0×",
    "paddingLeft": true,
    "position": {
      "character": 12,
      "line": 15
    },
    "tooltip": "How often it is executed in the whole program; every repeat by Q counts."
  }
]
=== request textDocument/inlayHint L9001@1..2
=== answer
[
  {
    "label": "called 2×",
    "paddingLeft": true,
    "position": {
      "character": 12,
      "line": 0
    },
    "tooltip": "How often it is executed in the whole program; every repeat by Q counts."
  },
  {
    "label": "= 5, 7.5",
    "paddingLeft": true,
    "position": {
      "character": 14,
      "line": 1
    },
    "tooltip": "R1 before the block: 5, 7.5"
  },
  {
    "label": "= 7.5",
    "paddingLeft": true,
    "position": {
      "character": 26,
      "line": 1
    },
    "tooltip": "R2 before the block: 7.5"
  }
]
=== replace L9001 a b
-R1
=== said workspace/inlayHint/refresh
null
=== request textDocument/inlayHint L9001@1..2
=== answer
[
  {
    "label": "called 2×",
    "paddingLeft": true,
    "position": {
      "character": 12,
      "line": 0
    },
    "tooltip": "How often it is executed in the whole program; every repeat by Q counts."
  },
  {
    "label": "= -5, -7.5",
    "paddingLeft": true,
    "position": {
      "character": 15,
      "line": 1
    },
    "tooltip": "R1 before the block: 5, 7.5"
  },
  {
    "label": "= 7.5",
    "paddingLeft": true,
    "position": {
      "character": 27,
      "line": 1
    },
    "tooltip": "R2 before the block: 7.5"
  }
]
