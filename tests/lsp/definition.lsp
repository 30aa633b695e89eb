# Where numbers lead: blocks, subprograms, macrocycles, also of the cycle map, and the assignments of parameters.
=== file cnc872c.toml
[cycles]
G81 = 8100
[operations]
1 = "add"
=== file L9001
N1 G79 L9001
N2 G00 XR10
N3 G70
=== file L8100
N1 G79 L8100
N2 R11=3
N3 G70
=== open part.nc
%306
N10 R10=5 R11=2
N20 G00 XR‹read›10 G73 L‹ahead›00040
N30 G26 R5=01‹field›101112
N40 G‹by function›71 L1‹sub›00 Q2
N50 G72 L‹macro›9001
N60 G8‹cycle›1 Z1
N70 G73 L‹parametric›R10 Q1
N80 G73 L‹nowhere›99
N90 M30
N100 G79 L100
N110 Y1 G73 L‹outside›10
N120 G70
=== request textDocument/definition part.nc@read
=== answer
[
  {
    "range": {
      "end": {
        "character": 7,
        "line": 1
      },
      "start": {
        "character": 5,
        "line": 1
      }
    },
    "uri": "DIR/part.nc"
  }
]
=== request textDocument/definition part.nc@ahead
=== answer
[
  {
    "range": {
      "end": {
        "character": 3,
        "line": 4
      },
      "start": {
        "character": 0,
        "line": 4
      }
    },
    "uri": "DIR/part.nc"
  }
]
=== request textDocument/declaration part.nc@field
=== answer
[
  {
    "range": {
      "end": {
        "character": 7,
        "line": 1
      },
      "start": {
        "character": 5,
        "line": 1
      }
    },
    "uri": "DIR/part.nc"
  }
]
=== request textDocument/definition part.nc@by function
=== answer
[
  {
    "range": {
      "end": {
        "character": 13,
        "line": 10
      },
      "start": {
        "character": 10,
        "line": 10
      }
    },
    "uri": "DIR/part.nc"
  }
]
=== request textDocument/definition part.nc@sub
=== answer
[
  {
    "range": {
      "end": {
        "character": 13,
        "line": 10
      },
      "start": {
        "character": 10,
        "line": 10
      }
    },
    "uri": "DIR/part.nc"
  }
]
=== request textDocument/definition part.nc@macro
=== answer
[
  {
    "range": {
      "end": {
        "character": 12,
        "line": 0
      },
      "start": {
        "character": 8,
        "line": 0
      }
    },
    "uri": "DIR/L9001"
  }
]
=== request textDocument/definition part.nc@cycle
=== answer
[
  {
    "range": {
      "end": {
        "character": 12,
        "line": 0
      },
      "start": {
        "character": 8,
        "line": 0
      }
    },
    "uri": "DIR/L8100"
  }
]
=== request textDocument/definition part.nc@parametric
=== answer
[
  {
    "range": {
      "end": {
        "character": 7,
        "line": 1
      },
      "start": {
        "character": 5,
        "line": 1
      }
    },
    "uri": "DIR/part.nc"
  }
]
=== request textDocument/definition part.nc@nowhere
=== answer
null
=== request textDocument/definition part.nc@outside
=== answer
[
  {
    "range": {
      "end": {
        "character": 3,
        "line": 1
      },
      "start": {
        "character": 0,
        "line": 1
      }
    },
    "uri": "DIR/part.nc"
  }
]
=== request textDocument/documentLink part.nc
=== answer
[
  {
    "range": {
      "end": {
        "character": 13,
        "line": 5
      },
      "start": {
        "character": 9,
        "line": 5
      }
    },
    "target": "DIR/L9001",
    "tooltip": "open macrocycle L9001"
  },
  {
    "range": {
      "end": {
        "character": 7,
        "line": 6
      },
      "start": {
        "character": 4,
        "line": 6
      }
    },
    "target": "DIR/L8100",
    "tooltip": "open macrocycle L8100"
  }
]
=== close part.nc
=== open L9001
N1 G79 L9001
N2 G00 X1 G73 L‹jump›1
N3 G72 L‹other›8100
N4 G70
=== request textDocument/definition L9001@jump
=== answer
[
  {
    "range": {
      "end": {
        "character": 2,
        "line": 0
      },
      "start": {
        "character": 0,
        "line": 0
      }
    },
    "uri": "DIR/L9001"
  }
]
=== request textDocument/definition L9001@other
=== answer
[
  {
    "range": {
      "end": {
        "character": 12,
        "line": 0
      },
      "start": {
        "character": 8,
        "line": 0
      }
    },
    "uri": "DIR/L8100"
  }
]
