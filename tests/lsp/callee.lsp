# What a call leads to: the comments of its unit and the values that it takes, in hovers, items and signatures.
=== client
{ "locale": "en", "capabilities": { "textDocument": { "hover": { "contentFormat": ["plaintext"] } } } }
=== file L9001
"Circle of holes"
"Inputs: R10 count, R11 radius"
N10 G79 L9001
N20 R12=R11
N30 G0 XR12
N40 G73 L30 QR10
N50 G70
=== open part.nc
%1 "part"
N10 T3 M06 "Drill 8.5"
N20 G0 X0
N30 R10=2 R11=25.5
N40 G72 ‹call›L9001
N50 G71 ‹sub›L100
N60 ‹tool›T3
N70 X7
N80 M30
"Pocket, rough"
N100 G79 L100
"in three passes"
N110 X5
N120 G70
=== request textDocument/hover part.nc@call
=== answer
{
  "contents": {
    "kind": "plaintext",
    "value": "L9001: number of a subprogram or macrocycle, or the block to jump to\ncalls macrocycle L9001\ntarget: N10 G79 L9001 in L9001\nCircle of holes\nInputs: R10 count, R11 radius\ntakes: R10 = 2; R11 = 25.5\n\nN40 runs 1×\nposition after the block: X 0 mm\nG functions in force: G00 G17 G98 G40 G53 G94 G72 G80 G90 G75 G34\nM functions after the block: M05 M40 M09 M53 M48\ntechnology: T3"
  },
  "range": {
    "end": {
      "character": 13,
      "line": 4
    },
    "start": {
      "character": 8,
      "line": 4
    }
  }
}
=== request textDocument/hover part.nc@sub
=== answer
{
  "contents": {
    "kind": "plaintext",
    "value": "L100: number of a subprogram or macrocycle, or the block to jump to\ncalls subprogram L100\ntarget: N100 G79 L100\nPocket, rough\nin three passes\n\nN50 runs 1×\nposition after the block: X 25.5 mm\nG functions in force: G00 G17 G98 G40 G53 G94 G71 G80 G90 G75 G34\nM functions after the block: M05 M40 M09 M53 M48\ntechnology: T3"
  },
  "range": {
    "end": {
      "character": 12,
      "line": 5
    },
    "start": {
      "character": 8,
      "line": 5
    }
  }
}
=== request textDocument/hover part.nc@tool
=== answer
{
  "contents": {
    "kind": "plaintext",
    "value": "T3: tool number; M06 changes the tool\nholds until changed\n“Drill 8.5”\nthe PLC reads: BLK.TProg=1 BLK.T=03h PB07=03h PB08=00h PB09=00h PB10=00h ZMSTPI=1\n\nN60 runs 1×\nposition after the block: X 5 mm\nG functions in force: G00 G17 G98 G40 G53 G94 G80 G90 G75 G34\nM functions after the block: M05 M40 M09 M53 M48\ntechnology: T3"
  },
  "range": {
    "end": {
      "character": 6,
      "line": 6
    },
    "start": {
      "character": 4,
      "line": 6
    }
  }
}
=== request textDocument/signatureHelp part.nc@call
=== answer
{
  "activeSignature": 0,
  "signatures": [
    {
      "documentation": "Circle of holes\nInputs: R10 count, R11 radius",
      "label": "L9001: R10 = 2, R11 = 25.5",
      "parameters": [
        {
          "label": "R10 = 2"
        },
        {
          "label": "R11 = 25.5"
        }
      ]
    }
  ]
}
=== text part.nc
%1 "part"
N10 G72 L‹macro›
N20 G71 L‹sub›
N30 G73 L‹block›
"Next section"
N40 G0 X0
N50 X1 "here"
N80 M30
"Pocket, rough"
N100 G79 L100
"in three passes"
N110 X5
N120 G70
=== request textDocument/completion part.nc@macro
=== answer
{
  "isIncomplete": false,
  "items": [
    {
      "detail": "Circle of holes, L9001",
      "documentation": {
        "kind": "markdown",
        "value": "Circle of holes  \nInputs: R10 count, R11 radius"
      },
      "filterText": "L9001",
      "kind": 17,
      "label": "L9001",
      "sortText": "00000009001",
      "textEdit": {
        "newText": "L9001",
        "range": {
          "end": {
            "character": 9,
            "line": 1
          },
          "start": {
            "character": 8,
            "line": 1
          }
        }
      }
    }
  ]
}
=== request textDocument/completion part.nc@sub
=== answer
{
  "isIncomplete": false,
  "items": [
    {
      "detail": "Pocket, rough, not called",
      "documentation": {
        "kind": "markdown",
        "value": "Pocket, rough  \nin three passes"
      },
      "filterText": "L100",
      "kind": 3,
      "label": "L100",
      "sortText": "00000000100",
      "textEdit": {
        "newText": "L100",
        "range": {
          "end": {
            "character": 9,
            "line": 2
          },
          "start": {
            "character": 8,
            "line": 2
          }
        }
      }
    }
  ]
}
=== request textDocument/completion part.nc@block
=== answer
{
  "isIncomplete": false,
  "items": [
    {
      "detail": "G71 L",
      "filterText": "L20",
      "kind": 18,
      "label": "L20",
      "sortText": "00000000001",
      "textEdit": {
        "newText": "L20",
        "range": {
          "end": {
            "character": 9,
            "line": 3
          },
          "start": {
            "character": 8,
            "line": 3
          }
        }
      }
    },
    {
      "detail": "G72 L",
      "filterText": "L10",
      "kind": 18,
      "label": "L10",
      "sortText": "00000000002",
      "textEdit": {
        "newText": "L10",
        "range": {
          "end": {
            "character": 9,
            "line": 3
          },
          "start": {
            "character": 8,
            "line": 3
          }
        }
      }
    },
    {
      "detail": "Next section",
      "filterText": "L40",
      "kind": 18,
      "label": "L40",
      "sortText": "10000000001",
      "textEdit": {
        "newText": "L40",
        "range": {
          "end": {
            "character": 9,
            "line": 3
          },
          "start": {
            "character": 8,
            "line": 3
          }
        }
      }
    },
    {
      "detail": "here",
      "filterText": "L50",
      "kind": 18,
      "label": "L50",
      "sortText": "10000000002",
      "textEdit": {
        "newText": "L50",
        "range": {
          "end": {
            "character": 9,
            "line": 3
          },
          "start": {
            "character": 8,
            "line": 3
          }
        }
      }
    },
    {
      "detail": "M30",
      "filterText": "L80",
      "kind": 18,
      "label": "L80",
      "sortText": "10000000003",
      "textEdit": {
        "newText": "L80",
        "range": {
          "end": {
            "character": 9,
            "line": 3
          },
          "start": {
            "character": 8,
            "line": 3
          }
        }
      }
    }
  ]
}
