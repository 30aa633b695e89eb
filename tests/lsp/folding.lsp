# Units, loops and comments of several lines.
=== open part.nc
%1 "a"
"b"
"c"
N10 G1 F100 X1
N20 G91 X1
N30 G91 Y1
N40 G73 L20 Q2
N50 G73 L10 Q3 "with a comment"
N60 G73 L80
N80 M30

"of the
"subprogram"
N100 G79 L5
N110 X1
N120 G70
=== request textDocument/foldingRange part.nc
=== answer
[
  {
    "endLine": 9,
    "kind": "region",
    "startLine": 0
  },
  {
    "endLine": 2,
    "kind": "comment",
    "startLine": 1
  },
  {
    "endLine": 7,
    "kind": "region",
    "startLine": 3
  },
  {
    "endLine": 6,
    "kind": "region",
    "startLine": 4
  },
  {
    "endLine": 12,
    "kind": "comment",
    "startLine": 11
  },
  {
    "endLine": 15,
    "kind": "region",
    "startLine": 13
  }
]
=== request textDocument/selectionRange part.nc
{ "positions": [{ "line": 5, "character": 9 }, { "line": 1, "character": 2 }, { "line": 14, "character": 3 }] }
=== answer
[
  {
    "parent": {
      "parent": {
        "parent": {
          "parent": {
            "parent": {
              "parent": {
                "range": {
                  "end": {
                    "character": 0,
                    "line": 16
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
                  "line": 9
                },
                "start": {
                  "character": 0,
                  "line": 0
                }
              }
            },
            "range": {
              "end": {
                "character": 31,
                "line": 7
              },
              "start": {
                "character": 0,
                "line": 3
              }
            }
          },
          "range": {
            "end": {
              "character": 14,
              "line": 6
            },
            "start": {
              "character": 0,
              "line": 4
            }
          }
        },
        "range": {
          "end": {
            "character": 10,
            "line": 5
          },
          "start": {
            "character": 0,
            "line": 5
          }
        }
      },
      "range": {
        "end": {
          "character": 10,
          "line": 5
        },
        "start": {
          "character": 8,
          "line": 5
        }
      }
    },
    "range": {
      "end": {
        "character": 10,
        "line": 5
      },
      "start": {
        "character": 9,
        "line": 5
      }
    }
  },
  {
    "range": {
      "end": {
        "character": 0,
        "line": 16
      },
      "start": {
        "character": 0,
        "line": 0
      }
    }
  },
  {
    "parent": {
      "parent": {
        "parent": {
          "parent": {
            "range": {
              "end": {
                "character": 0,
                "line": 16
              },
              "start": {
                "character": 0,
                "line": 0
              }
            }
          },
          "range": {
            "end": {
              "character": 8,
              "line": 15
            },
            "start": {
              "character": 0,
              "line": 11
            }
          }
        },
        "range": {
          "end": {
            "character": 7,
            "line": 14
          },
          "start": {
            "character": 0,
            "line": 14
          }
        }
      },
      "range": {
        "end": {
          "character": 4,
          "line": 14
        },
        "start": {
          "character": 0,
          "line": 14
        }
      }
    },
    "range": {
      "end": {
        "character": 4,
        "line": 14
      },
      "start": {
        "character": 1,
        "line": 14
      }
    }
  }
]
