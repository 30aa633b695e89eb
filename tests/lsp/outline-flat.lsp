# A client that knows no tree gets a list.
=== client
{ "locale": "cs" }
=== open part.nc
%7
N10 T5
"Rez"
N20 G1 X1 F100
N30 M30
N40 G79 L
N50 G70
=== request textDocument/documentSymbol part.nc
=== answer
[
  {
    "kind": 2,
    "location": {
      "range": {
        "end": {
          "character": 7,
          "line": 4
        },
        "start": {
          "character": 0,
          "line": 0
        }
      },
      "uri": "DIR/part.nc"
    },
    "name": "%7"
  },
  {
    "containerName": "%7",
    "kind": 24,
    "location": {
      "range": {
        "end": {
          "character": 6,
          "line": 1
        },
        "start": {
          "character": 0,
          "line": 1
        }
      },
      "uri": "DIR/part.nc"
    },
    "name": "N10 T5"
  },
  {
    "containerName": "%7",
    "kind": 15,
    "location": {
      "range": {
        "end": {
          "character": 7,
          "line": 4
        },
        "start": {
          "character": 0,
          "line": 2
        }
      },
      "uri": "DIR/part.nc"
    },
    "name": "Rez"
  },
  {
    "kind": 12,
    "location": {
      "range": {
        "end": {
          "character": 7,
          "line": 6
        },
        "start": {
          "character": 0,
          "line": 5
        }
      },
      "uri": "DIR/part.nc"
    },
    "name": "L?"
  }
]
