# The length of a path that is not known is not said to be nothing (editor 5): G91 from an unknown place, an unmapped cycle, a call that cannot be followed.
=== open cycle.nc
%1
N10 G90 G00 X0 Y0 Z5 F100
N20 G81 X10 Y10 Z-5
N30 G80
N40 M30
=== findings cycle.nc
2:4-2:7 W0612 how the fixed cycle G81 moves is not known: its blocks have no motion here | help: name the macrocycle that the machine runs for it in the project file: `[cycles]`, `G81 = …`
=== request textDocument/codeLens cycle.nc
=== answer
[
  {
    "command": {
      "command": "",
      "title": "executed blocks: 4, path unknown"
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
=== open call.nc
%2
N10 G72 L9001
N20 G90 G00 X5
N30 M30
=== request textDocument/codeLens call.nc
=== answer
[
  {
    "command": {
      "command": "",
      "title": "executed blocks: 3, path unknown"
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
=== open reference.nc
%3
N10 G30 X0 Y0 Z0
N20 M30
=== findings reference.nc
=== request textDocument/codeLens reference.nc
=== answer
[
  {
    "command": {
      "command": "",
      "title": "executed blocks: 2, path unknown"
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
