# Comments grow by their text, then their quotes; what is no program is only the file.
=== open part.nc
%1
N10 X1 "řez a" Y2
N20 M30
=== request textDocument/selectionRange part.nc
{ "positions": [{ "line": 1, "character": 9 }] }
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
              "line": 0
            }
          }
        },
        "range": {
          "end": {
            "character": 17,
            "line": 1
          },
          "start": {
            "character": 0,
            "line": 1
          }
        }
      },
      "range": {
        "end": {
          "character": 14,
          "line": 1
        },
        "start": {
          "character": 7,
          "line": 1
        }
      }
    },
    "range": {
      "end": {
        "character": 13,
        "line": 1
      },
      "start": {
        "character": 8,
        "line": 1
      }
    }
  }
]
=== open none.nc
X5
=== request textDocument/selectionRange none.nc
{ "positions": [{ "line": 0, "character": 1 }] }
=== answer
[
  {
    "range": {
      "end": {
        "character": 0,
        "line": 1
      },
      "start": {
        "character": 0,
        "line": 0
      }
    }
  }
]
