# The outline, as a tree and flat, of programs, macrocycles and what is being typed.
=== client
{ "capabilities": { "textDocument": { "documentSymbol": { "hierarchicalDocumentSymbolSupport": true } } } }
=== open part.nc
not read
%1200 "PRIRUBA 120 x 80"
" Material: ocel"
N10 G54 G17
N20 T1 M06   "Freza D16"
N30 T2 "predvolba"

"--- Obvod hrubovat ---"
"tri vrstvy"
N40 G71 L100 Q3
"N45 G71 L100"
"-------------"
"Otvory"
"-------------"
N50 M06 "Vrtak"
N60 "jen poznamka"
N70 M30 "konec"
"--- L100: jedna vrstva ---"
N1000 G79 L100
"uvnitr"
N1010 X5
"Dokonceni"
N1020 G70

N2000 G79 L200 "druhy"
N2010 G70
*
=== request textDocument/documentSymbol part.nc
=== answer
[
  {
    "children": [
      {
        "kind": 24,
        "name": "N20 T1 Freza D16",
        "range": {
          "end": {
            "character": 18,
            "line": 5
          },
          "start": {
            "character": 0,
            "line": 4
          }
        },
        "selectionRange": {
          "end": {
            "character": 10,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      },
      {
        "kind": 15,
        "name": "Obvod hrubovat",
        "range": {
          "end": {
            "character": 15,
            "line": 11
          },
          "start": {
            "character": 0,
            "line": 7
          }
        },
        "selectionRange": {
          "end": {
            "character": 24,
            "line": 7
          },
          "start": {
            "character": 0,
            "line": 7
          }
        }
      },
      {
        "kind": 15,
        "name": "Otvory",
        "range": {
          "end": {
            "character": 15,
            "line": 13
          },
          "start": {
            "character": 0,
            "line": 12
          }
        },
        "selectionRange": {
          "end": {
            "character": 8,
            "line": 12
          },
          "start": {
            "character": 0,
            "line": 12
          }
        }
      },
      {
        "kind": 24,
        "name": "N50 T2 Vrtak",
        "range": {
          "end": {
            "character": 15,
            "line": 14
          },
          "start": {
            "character": 0,
            "line": 14
          }
        },
        "selectionRange": {
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
      {
        "kind": 15,
        "name": "jen poznamka",
        "range": {
          "end": {
            "character": 15,
            "line": 16
          },
          "start": {
            "character": 0,
            "line": 15
          }
        },
        "selectionRange": {
          "end": {
            "character": 18,
            "line": 15
          },
          "start": {
            "character": 0,
            "line": 15
          }
        }
      }
    ],
    "kind": 2,
    "name": "%1200 PRIRUBA 120 x 80",
    "range": {
      "end": {
        "character": 15,
        "line": 16
      },
      "start": {
        "character": 0,
        "line": 1
      }
    },
    "selectionRange": {
      "end": {
        "character": 5,
        "line": 1
      },
      "start": {
        "character": 0,
        "line": 1
      }
    }
  },
  {
    "children": [
      {
        "kind": 15,
        "name": "uvnitr",
        "range": {
          "end": {
            "character": 8,
            "line": 20
          },
          "start": {
            "character": 0,
            "line": 19
          }
        },
        "selectionRange": {
          "end": {
            "character": 8,
            "line": 19
          },
          "start": {
            "character": 0,
            "line": 19
          }
        }
      },
      {
        "kind": 15,
        "name": "Dokonceni",
        "range": {
          "end": {
            "character": 9,
            "line": 22
          },
          "start": {
            "character": 0,
            "line": 21
          }
        },
        "selectionRange": {
          "end": {
            "character": 11,
            "line": 21
          },
          "start": {
            "character": 0,
            "line": 21
          }
        }
      }
    ],
    "kind": 12,
    "name": "L100 jedna vrstva",
    "range": {
      "end": {
        "character": 9,
        "line": 22
      },
      "start": {
        "character": 0,
        "line": 17
      }
    },
    "selectionRange": {
      "end": {
        "character": 14,
        "line": 18
      },
      "start": {
        "character": 0,
        "line": 18
      }
    }
  },
  {
    "children": [],
    "kind": 12,
    "name": "L200 druhy",
    "range": {
      "end": {
        "character": 9,
        "line": 25
      },
      "start": {
        "character": 0,
        "line": 24
      }
    },
    "selectionRange": {
      "end": {
        "character": 14,
        "line": 24
      },
      "start": {
        "character": 0,
        "line": 24
      }
    }
  }
]
=== open L9001
"- L9001 VRTANI NA KRUZNICI -"
N1 G79 L9001
N2 T R5
N3 G70
=== request textDocument/documentSymbol L9001
=== answer
[
  {
    "children": [
      {
        "kind": 24,
        "name": "N2 TR5",
        "range": {
          "end": {
            "character": 6,
            "line": 3
          },
          "start": {
            "character": 0,
            "line": 2
          }
        },
        "selectionRange": {
          "end": {
            "character": 7,
            "line": 2
          },
          "start": {
            "character": 0,
            "line": 2
          }
        }
      }
    ],
    "kind": 12,
    "name": "L9001 VRTANI NA KRUZNICI",
    "range": {
      "end": {
        "character": 6,
        "line": 3
      },
      "start": {
        "character": 0,
        "line": 0
      }
    },
    "selectionRange": {
      "end": {
        "character": 12,
        "line": 1
      },
      "start": {
        "character": 0,
        "line": 1
      }
    }
  }
]
=== open typed.nc
N10 X5
=== request textDocument/documentSymbol typed.nc
=== answer
[]
