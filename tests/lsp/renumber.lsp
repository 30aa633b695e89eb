# New numbers, or why there are none.
=== client
{
  "capabilities": {
    "textDocument": {
      "codeAction": { "codeActionLiteralSupport": { "codeActionKind": { "valueSet": [] } }, "disabledSupport": true }
    }
  }
}
=== open part.nc
%20 "ř"
‹1›N1 G71 L100
N 2 G1 F100 X1 N3 G73 L0002 Q1
N4 X2 N4 X3
N5 G73 L7
N7 M30
N100 G79 L100
N110 X1
N120 G73 L110 Q2
N130 G70
*
N9 not read
=== request textDocument/codeAction part.nc@1..1
{ "context": { "diagnostics": [], "only": ["source.renumber"] } }
=== answer
[
  {
    "edit": {
      "changes": {
        "DIR/part.nc": [
          {
            "newText": "10",
            "range": {
              "end": {
                "character": 2,
                "line": 1
              },
              "start": {
                "character": 1,
                "line": 1
              }
            }
          },
          {
            "newText": "20",
            "range": {
              "end": {
                "character": 3,
                "line": 2
              },
              "start": {
                "character": 2,
                "line": 2
              }
            }
          },
          {
            "newText": "30",
            "range": {
              "end": {
                "character": 17,
                "line": 2
              },
              "start": {
                "character": 16,
                "line": 2
              }
            }
          },
          {
            "newText": "20",
            "range": {
              "end": {
                "character": 27,
                "line": 2
              },
              "start": {
                "character": 23,
                "line": 2
              }
            }
          },
          {
            "newText": "40",
            "range": {
              "end": {
                "character": 2,
                "line": 3
              },
              "start": {
                "character": 1,
                "line": 3
              }
            }
          },
          {
            "newText": "50",
            "range": {
              "end": {
                "character": 8,
                "line": 3
              },
              "start": {
                "character": 7,
                "line": 3
              }
            }
          },
          {
            "newText": "60",
            "range": {
              "end": {
                "character": 2,
                "line": 4
              },
              "start": {
                "character": 1,
                "line": 4
              }
            }
          },
          {
            "newText": "70",
            "range": {
              "end": {
                "character": 9,
                "line": 4
              },
              "start": {
                "character": 8,
                "line": 4
              }
            }
          },
          {
            "newText": "70",
            "range": {
              "end": {
                "character": 2,
                "line": 5
              },
              "start": {
                "character": 1,
                "line": 5
              }
            }
          },
          {
            "newText": "80",
            "range": {
              "end": {
                "character": 4,
                "line": 6
              },
              "start": {
                "character": 1,
                "line": 6
              }
            }
          },
          {
            "newText": "90",
            "range": {
              "end": {
                "character": 4,
                "line": 7
              },
              "start": {
                "character": 1,
                "line": 7
              }
            }
          },
          {
            "newText": "100",
            "range": {
              "end": {
                "character": 4,
                "line": 8
              },
              "start": {
                "character": 1,
                "line": 8
              }
            }
          },
          {
            "newText": "90",
            "range": {
              "end": {
                "character": 13,
                "line": 8
              },
              "start": {
                "character": 10,
                "line": 8
              }
            }
          },
          {
            "newText": "110",
            "range": {
              "end": {
                "character": 4,
                "line": 9
              },
              "start": {
                "character": 1,
                "line": 9
              }
            }
          }
        ]
      }
    },
    "kind": "source.renumber.cnc872c",
    "title": "renumber the blocks 10 by 10"
  }
]
=== edited
--- part.nc
%20 "ř"
N10 G71 L100
N 20 G1 F100 X1 N30 G73 L20 Q1
N40 X2 N50 X3
N60 G73 L70
N70 M30
N80 G79 L100
N90 X1
N100 G73 L90 Q2
N110 G70
*
N9 not read
=== text part.nc
%20
N10 M30
=== request textDocument/codeAction part.nc@1..1
{ "context": { "diagnostics": [], "only": ["source"] } }
=== answer
[
  {
    "disabled": {
      "reason": "the blocks have these numbers already"
    },
    "kind": "source.renumber.cnc872c",
    "title": "renumber the blocks 10 by 10"
  }
]
=== text part.nc
%20
N1 R1=1 G73 LR1
N2 M30
=== request textDocument/codeAction part.nc@1..1
{ "context": { "diagnostics": [], "only": ["source"] } }
=== answer
[
  {
    "disabled": {
      "reason": "where N1 in line 2 jumps depends on a parameter: LR1"
    },
    "kind": "source.renumber.cnc872c",
    "title": "renumber the blocks 10 by 10"
  }
]
=== text part.nc
%20
N1 X1
N1 GR1 L5
N2 M30
=== request textDocument/codeAction part.nc@1..1
{ "context": { "diagnostics": [], "only": ["source"] } }
=== answer
[
  {
    "disabled": {
      "reason": "where N1 in line 3 jumps depends on a parameter: GR1"
    },
    "kind": "source.renumber.cnc872c",
    "title": "renumber the blocks 10 by 10"
  }
]
=== text part.nc
%20
N1 X1
N1 X2
N2 G73 L1
N3 M30
=== request textDocument/codeAction part.nc@1..1
{ "context": { "diagnostics": [] } }
=== answer
[
  {
    "disabled": {
      "reason": "several blocks have the number N1 that a jump leads to"
    },
    "kind": "source.renumber.cnc872c",
    "title": "renumber the blocks 10 by 10"
  }
]
=== text part.nc
%20
N X1
N2 M30
=== request textDocument/codeAction part.nc@1..1
{ "context": { "diagnostics": [] } }
=== answer
[
  {
    "disabled": {
      "reason": "line 2 cannot be read (E0103)"
    },
    "kind": "source.renumber.cnc872c",
    "title": "renumber the blocks 10 by 10"
  }
]
=== text part.nc
%20 "the comment has exactly what fits when the numbers are one by one"
N8 "....:....1....:....2....:....3....:....4....:....5....:....6....:....7....:"
N9 M30
=== request textDocument/codeAction part.nc@1..1
{ "context": { "diagnostics": [] } }
=== answer
[
  {
    "edit": {
      "changes": {
        "DIR/part.nc": [
          {
            "newText": "5",
            "range": {
              "end": {
                "character": 2,
                "line": 1
              },
              "start": {
                "character": 1,
                "line": 1
              }
            }
          },
          {
            "newText": "10",
            "range": {
              "end": {
                "character": 2,
                "line": 2
              },
              "start": {
                "character": 1,
                "line": 2
              }
            }
          }
        ]
      }
    },
    "kind": "source.renumber.cnc872c",
    "title": "renumber the blocks 5 by 5"
  }
]
=== request textDocument/codeAction part.nc@1..1
{ "context": { "diagnostics": [], "triggerKind": 2 } }
=== answer
[]
