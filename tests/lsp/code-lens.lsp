# The blocks that call a unit; a program's length.
=== client
{ "locale": "cs" }
=== open L9001
N1 G79 L9001
N2 G91 G01 X1 F1000
N3 G70
=== open part.nc
%14
N10 G90 G0 X0 Y0 Z5
N20 G71 L10
N30 G72 L9001 Q2
N40 X10
N100 M30
N500 G79 L10 "hole"
N510 G90 G01 Z-0.8 F120
N520 G72 L9001
N530 Z5 G70
N600 G79 L20
N610 G70
=== findings part.nc
10:5-10:8 W0211 podprogram L20 žádná G71 nevolá | nápověda: zavolat ho pomocí „G71 L20“, nebo ho vymazat
=== request textDocument/codeLens part.nc
=== answer
[
  {
    "command": {
      "command": "",
      "title": "provedené bloky: 18, dráha 23.8 mm"
    },
    "range": {
      "end": {
        "character": 3,
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
          "character": 5,
          "line": 6
        },
        [
          {
            "range": {
              "end": {
                "character": 3,
                "line": 2
              },
              "start": {
                "character": 0,
                "line": 2
              }
            },
            "uri": "DIR/part.nc"
          }
        ]
      ],
      "command": "cnc872c.showReferences",
      "title": "volání: 1"
    },
    "range": {
      "end": {
        "character": 8,
        "line": 6
      },
      "start": {
        "character": 5,
        "line": 6
      }
    }
  },
  {
    "command": {
      "arguments": [
        "DIR/part.nc",
        {
          "character": 5,
          "line": 10
        },
        []
      ],
      "command": "cnc872c.showReferences",
      "title": "volání: 0"
    },
    "range": {
      "end": {
        "character": 8,
        "line": 10
      },
      "start": {
        "character": 5,
        "line": 10
      }
    }
  }
]
=== request textDocument/codeLens L9001
=== answer
[
  {
    "command": {
      "arguments": [
        "DIR/L9001",
        {
          "character": 3,
          "line": 0
        },
        [
          {
            "range": {
              "end": {
                "character": 3,
                "line": 3
              },
              "start": {
                "character": 0,
                "line": 3
              }
            },
            "uri": "DIR/part.nc"
          },
          {
            "range": {
              "end": {
                "character": 4,
                "line": 8
              },
              "start": {
                "character": 0,
                "line": 8
              }
            },
            "uri": "DIR/part.nc"
          }
        ]
      ],
      "command": "cnc872c.showReferences",
      "title": "volání: 2"
    },
    "range": {
      "end": {
        "character": 6,
        "line": 0
      },
      "start": {
        "character": 3,
        "line": 0
      }
    }
  }
]
