# A client that takes links gets the whole block or unit, and where in it to go.
=== client
{ "capabilities": { "textDocument": { "definition": { "linkSupport": true } } } }
=== open part.nc
%306
N10 G71 L‹sub›100
N20 G73 L‹jump›40 N30 X1
N40 G01
 X5 "c
N50 M30
N100 G79 L100
N110 Y1
N120 G70
=== request textDocument/definition part.nc@sub
=== answer
[
  {
    "originSelectionRange": {
      "end": {
        "character": 12,
        "line": 1
      },
      "start": {
        "character": 8,
        "line": 1
      }
    },
    "targetRange": {
      "end": {
        "character": 8,
        "line": 8
      },
      "start": {
        "character": 0,
        "line": 6
      }
    },
    "targetSelectionRange": {
      "end": {
        "character": 13,
        "line": 6
      },
      "start": {
        "character": 10,
        "line": 6
      }
    },
    "targetUri": "DIR/part.nc"
  }
]
=== request textDocument/definition part.nc@jump
=== answer
[
  {
    "originSelectionRange": {
      "end": {
        "character": 11,
        "line": 2
      },
      "start": {
        "character": 8,
        "line": 2
      }
    },
    "targetRange": {
      "end": {
        "character": 3,
        "line": 4
      },
      "start": {
        "character": 0,
        "line": 3
      }
    },
    "targetSelectionRange": {
      "end": {
        "character": 3,
        "line": 3
      },
      "start": {
        "character": 0,
        "line": 3
      }
    },
    "targetUri": "DIR/part.nc"
  }
]
