# An address with an accent is a character, and is in no selection by half.
=== open part.nc
%1
N10 X1
N20 Ý40
N30 M30
=== request textDocument/selectionRange part.nc
{ "positions": [{ "line": 2, "character": 5 }] }
=== answer
[
  {
    "parent": {
      "parent": {
        "parent": {
          "parent": {
            "range": {
              "end": {
                "character": 0,
                "line": 4
              },
              "start": {
                "character": 0,
                "line": 0
              }
            }
          },
          "range": {
            "end": {
              "character": 7,
              "line": 3
            },
            "start": {
              "character": 0,
              "line": 0
            }
          }
        },
        "range": {
          "end": {
            "character": 7,
            "line": 2
          },
          "start": {
            "character": 0,
            "line": 2
          }
        }
      },
      "range": {
        "end": {
          "character": 7,
          "line": 2
        },
        "start": {
          "character": 4,
          "line": 2
        }
      }
    },
    "range": {
      "end": {
        "character": 7,
        "line": 2
      },
      "start": {
        "character": 5,
        "line": 2
      }
    }
  }
]
