# A time that lacks blocks says how many: of a program and of each subprogram.
=== client
{ "locale": "en" }
=== file cnc872c.toml
[motion]
cycle-ms = 2
=== open part.nc
%1
N1 G23 G00 X0 Y0 F1000
N2 G01 X10 Z5
N3 X20 Y1
N4 X20 Y20 G81 Z3
N5 G71 L7 Q3
N6 M30
N7 G79 L7
N8 G91 G01 X5 G23
N9 X5 Y1 M3 S100
N10 G90 G70
=== request textDocument/codeLens part.nc
=== answer
[
  {
    "command": {
      "command": "",
      "title": "executed blocks: 18, path at least 10.05 mm, time at least 0:00:00.6; blocks of unknown time: 9"
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
          "character": 3,
          "line": 7
        },
        [
          {
            "range": {
              "end": {
                "character": 2,
                "line": 5
              },
              "start": {
                "character": 0,
                "line": 5
              }
            },
            "uri": "DIR/part.nc"
          }
        ]
      ],
      "command": "cnc872c.showReferences",
      "title": "1 call, time at least 0:00:00.0; blocks of unknown time: 6"
    },
    "range": {
      "end": {
        "character": 6,
        "line": 7
      },
      "start": {
        "character": 3,
        "line": 7
      }
    }
  }
]
=== open known.nc
%2
N1 G00 X0 Y0 F1000
N2 G01 X10
N3 M30
=== request textDocument/codeLens known.nc
=== answer
[
  {
    "command": {
      "command": "",
      "title": "executed blocks: 3, path 10 mm, time 0:00:00.6 without the approach"
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
  }
]
