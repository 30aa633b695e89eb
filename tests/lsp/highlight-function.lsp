# A G or M function is highlighted wherever the program has it, however its number is written; axes are not.
=== open a.nc
%1
N10 G90 G01 X1 Y1 F100 M3
N20 G‹arc›2 X5 Y5 I2 J2 M03
N30 g02 X‹x›9 Y9 I2 J2 M‹m›03
N40 G03 X1 Y1 I-4 J-4 M30
=== request textDocument/documentHighlight a.nc@arc
=== answer
[
  {
    "kind": 1,
    "range": {
      "end": {
        "character": 6,
        "line": 2
      },
      "start": {
        "character": 4,
        "line": 2
      }
    }
  },
  {
    "kind": 1,
    "range": {
      "end": {
        "character": 7,
        "line": 3
      },
      "start": {
        "character": 4,
        "line": 3
      }
    }
  }
]
=== request textDocument/documentHighlight a.nc@m
=== answer
[
  {
    "kind": 1,
    "range": {
      "end": {
        "character": 25,
        "line": 1
      },
      "start": {
        "character": 23,
        "line": 1
      }
    }
  },
  {
    "kind": 1,
    "range": {
      "end": {
        "character": 22,
        "line": 2
      },
      "start": {
        "character": 19,
        "line": 2
      }
    }
  },
  {
    "kind": 1,
    "range": {
      "end": {
        "character": 23,
        "line": 3
      },
      "start": {
        "character": 20,
        "line": 3
      }
    }
  }
]
=== request textDocument/documentHighlight a.nc@x
=== answer
null
