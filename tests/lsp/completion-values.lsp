# Behind T, F, S and the like stand the values that the program has already, the most frequent first.
=== open a.nc
%1
N10 T1 M06
N20 G90 G00 X0 Y0 S1200 M03
N30 G01 X10 F200
N40 X20 F350.5
N50 X30 F200
N60 T12 M06
N70 F‹f›
N80 T1‹t›
N90 X50
N100 M30
=== request textDocument/completion a.nc@f
=== answer
{
  "isIncomplete": false,
  "items": [
    {
      "detail": "2× in the program",
      "filterText": "F200",
      "kind": 12,
      "label": "F200",
      "sortText": "00000000000",
      "textEdit": {
        "newText": "F200",
        "range": {
          "end": {
            "character": 5,
            "line": 7
          },
          "start": {
            "character": 4,
            "line": 7
          }
        }
      }
    },
    {
      "detail": "1× in the program",
      "filterText": "F350.5",
      "kind": 12,
      "label": "F350.5",
      "sortText": "00000000001",
      "textEdit": {
        "newText": "F350.5",
        "range": {
          "end": {
            "character": 5,
            "line": 7
          },
          "start": {
            "character": 4,
            "line": 7
          }
        }
      }
    },
    {
      "detail": "feed: mm/min under G94 and G96, mm/rev under G95; under G97 by the key `g97`",
      "documentation": {
        "kind": "markdown",
        "value": "**F** – feed: mm/min under G94 and G96, mm/rev under G95; under G97 by the key `g97`\n\nValue: 1–99999 mm/min under G94, G96, G97; 0.001–99.999 mm/rev under G95.\n\nHolds until changed."
      },
      "filterText": "F",
      "kind": 5,
      "label": "F",
      "sortText": "20000000012",
      "textEdit": {
        "newText": "F",
        "range": {
          "end": {
            "character": 5,
            "line": 7
          },
          "start": {
            "character": 4,
            "line": 7
          }
        }
      }
    }
  ]
}
=== request textDocument/completion a.nc@t
=== answer
{
  "isIncomplete": false,
  "items": [
    {
      "detail": "1× in the program",
      "filterText": "T1",
      "kind": 12,
      "label": "T1",
      "sortText": "00000000000",
      "textEdit": {
        "newText": "T1",
        "range": {
          "end": {
            "character": 6,
            "line": 8
          },
          "start": {
            "character": 4,
            "line": 8
          }
        }
      }
    },
    {
      "detail": "1× in the program",
      "filterText": "T12",
      "kind": 12,
      "label": "T12",
      "sortText": "00000000001",
      "textEdit": {
        "newText": "T12",
        "range": {
          "end": {
            "character": 6,
            "line": 8
          },
          "start": {
            "character": 4,
            "line": 8
          }
        }
      }
    }
  ]
}
