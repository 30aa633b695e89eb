# Who calls whom, also from files that are not open and by the cycle map.
=== file cnc872c.toml
[cycles]
G81 = 8100
=== file L9001
N1 G79 L9001
N2 G72 L9002
N3 G70
=== file L9002
N1 G79 L9002
N2 G70
=== file L8100
N1 G79 L8100
N2 G70
=== open part.nc
%306 "flange
N10 G71 L‹sub›100 Q2
N20 G72 L‹macro›9001
N30 G81 Z1
N40 G71 L100
N50 ‹main›M30
N100 G79 L100
N110 G72 L9001
N120 G70
=== open other.nc
%307
N10 G72 L9001
N20 M30
=== request textDocument/prepareCallHierarchy part.nc@main
=== answer
[
  {
    "data": {
      "unit": "main"
    },
    "detail": "flange",
    "kind": 2,
    "name": "%306",
    "range": {
      "end": {
        "character": 7,
        "line": 5
      },
      "start": {
        "character": 0,
        "line": 0
      }
    },
    "selectionRange": {
      "end": {
        "character": 4,
        "line": 0
      },
      "start": {
        "character": 0,
        "line": 0
      }
    },
    "uri": "DIR/part.nc"
  }
]
=== request callHierarchy/outgoingCalls
{ "item": { "name": "%306", "kind": 2, "uri": "DIR/part.nc", "range": { "start": { "line": 0, "character": 0 }, "end": { "line": 0, "character": 0 } }, "selectionRange": { "start": { "line": 0, "character": 0 }, "end": { "line": 0, "character": 0 } }, "data": { "unit": "main" } } }
=== answer
[
  {
    "fromRanges": [
      {
        "end": {
          "character": 12,
          "line": 1
        },
        "start": {
          "character": 9,
          "line": 1
        }
      },
      {
        "end": {
          "character": 12,
          "line": 4
        },
        "start": {
          "character": 9,
          "line": 4
        }
      }
    ],
    "to": {
      "data": {
        "l": 100,
        "unit": "subprogram"
      },
      "detail": "subprogram",
      "kind": 12,
      "name": "L100",
      "range": {
        "end": {
          "character": 8,
          "line": 8
        },
        "start": {
          "character": 0,
          "line": 6
        }
      },
      "selectionRange": {
        "end": {
          "character": 13,
          "line": 6
        },
        "start": {
          "character": 10,
          "line": 6
        }
      },
      "uri": "DIR/part.nc"
    }
  },
  {
    "fromRanges": [
      {
        "end": {
          "character": 13,
          "line": 2
        },
        "start": {
          "character": 9,
          "line": 2
        }
      }
    ],
    "to": {
      "data": {
        "unit": "macrocycle"
      },
      "detail": "macrocycle L9001",
      "kind": 12,
      "name": "L9001",
      "range": {
        "end": {
          "character": 6,
          "line": 2
        },
        "start": {
          "character": 0,
          "line": 0
        }
      },
      "selectionRange": {
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
  },
  {
    "fromRanges": [
      {
        "end": {
          "character": 7,
          "line": 3
        },
        "start": {
          "character": 4,
          "line": 3
        }
      }
    ],
    "to": {
      "data": {
        "unit": "macrocycle"
      },
      "detail": "macrocycle L8100",
      "kind": 12,
      "name": "L8100",
      "range": {
        "end": {
          "character": 6,
          "line": 1
        },
        "start": {
          "character": 0,
          "line": 0
        }
      },
      "selectionRange": {
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
  }
]
=== request textDocument/prepareCallHierarchy part.nc@sub
=== answer
[
  {
    "data": {
      "l": 100,
      "unit": "subprogram"
    },
    "detail": "subprogram",
    "kind": 12,
    "name": "L100",
    "range": {
      "end": {
        "character": 8,
        "line": 8
      },
      "start": {
        "character": 0,
        "line": 6
      }
    },
    "selectionRange": {
      "end": {
        "character": 13,
        "line": 6
      },
      "start": {
        "character": 10,
        "line": 6
      }
    },
    "uri": "DIR/part.nc"
  }
]
=== request callHierarchy/incomingCalls
{ "item": { "name": "L100", "kind": 12, "uri": "DIR/part.nc", "range": { "start": { "line": 6, "character": 0 }, "end": { "line": 6, "character": 0 } }, "selectionRange": { "start": { "line": 6, "character": 0 }, "end": { "line": 6, "character": 0 } }, "data": { "unit": "subprogram", "l": 100 } } }
=== answer
[
  {
    "from": {
      "data": {
        "unit": "main"
      },
      "detail": "flange",
      "kind": 2,
      "name": "%306",
      "range": {
        "end": {
          "character": 7,
          "line": 5
        },
        "start": {
          "character": 0,
          "line": 0
        }
      },
      "selectionRange": {
        "end": {
          "character": 4,
          "line": 0
        },
        "start": {
          "character": 0,
          "line": 0
        }
      },
      "uri": "DIR/part.nc"
    },
    "fromRanges": [
      {
        "end": {
          "character": 12,
          "line": 1
        },
        "start": {
          "character": 9,
          "line": 1
        }
      },
      {
        "end": {
          "character": 12,
          "line": 4
        },
        "start": {
          "character": 9,
          "line": 4
        }
      }
    ]
  }
]
=== request callHierarchy/incomingCalls
{ "item": { "name": "L9001", "kind": 12, "uri": "DIR/L9001", "range": { "start": { "line": 0, "character": 0 }, "end": { "line": 0, "character": 0 } }, "selectionRange": { "start": { "line": 0, "character": 0 }, "end": { "line": 0, "character": 0 } }, "data": { "unit": "macrocycle" } } }
=== answer
[
  {
    "from": {
      "data": {
        "unit": "main"
      },
      "detail": "main program",
      "kind": 2,
      "name": "%307",
      "range": {
        "end": {
          "character": 7,
          "line": 2
        },
        "start": {
          "character": 0,
          "line": 0
        }
      },
      "selectionRange": {
        "end": {
          "character": 4,
          "line": 0
        },
        "start": {
          "character": 0,
          "line": 0
        }
      },
      "uri": "DIR/other.nc"
    },
    "fromRanges": [
      {
        "end": {
          "character": 13,
          "line": 1
        },
        "start": {
          "character": 9,
          "line": 1
        }
      }
    ]
  },
  {
    "from": {
      "data": {
        "unit": "main"
      },
      "detail": "flange",
      "kind": 2,
      "name": "%306",
      "range": {
        "end": {
          "character": 7,
          "line": 5
        },
        "start": {
          "character": 0,
          "line": 0
        }
      },
      "selectionRange": {
        "end": {
          "character": 4,
          "line": 0
        },
        "start": {
          "character": 0,
          "line": 0
        }
      },
      "uri": "DIR/part.nc"
    },
    "fromRanges": [
      {
        "end": {
          "character": 13,
          "line": 2
        },
        "start": {
          "character": 9,
          "line": 2
        }
      }
    ]
  },
  {
    "from": {
      "data": {
        "l": 100,
        "unit": "subprogram"
      },
      "detail": "subprogram",
      "kind": 12,
      "name": "L100",
      "range": {
        "end": {
          "character": 8,
          "line": 8
        },
        "start": {
          "character": 0,
          "line": 6
        }
      },
      "selectionRange": {
        "end": {
          "character": 13,
          "line": 6
        },
        "start": {
          "character": 10,
          "line": 6
        }
      },
      "uri": "DIR/part.nc"
    },
    "fromRanges": [
      {
        "end": {
          "character": 14,
          "line": 7
        },
        "start": {
          "character": 10,
          "line": 7
        }
      }
    ]
  }
]
=== request callHierarchy/outgoingCalls
{ "item": { "name": "L9001", "kind": 12, "uri": "DIR/L9001", "range": { "start": { "line": 0, "character": 0 }, "end": { "line": 0, "character": 0 } }, "selectionRange": { "start": { "line": 0, "character": 0 }, "end": { "line": 0, "character": 0 } }, "data": { "unit": "macrocycle" } } }
=== answer
[
  {
    "fromRanges": [
      {
        "end": {
          "character": 12,
          "line": 1
        },
        "start": {
          "character": 8,
          "line": 1
        }
      }
    ],
    "to": {
      "data": {
        "unit": "macrocycle"
      },
      "detail": "macrocycle L9002",
      "kind": 12,
      "name": "L9002",
      "range": {
        "end": {
          "character": 6,
          "line": 1
        },
        "start": {
          "character": 0,
          "line": 0
        }
      },
      "selectionRange": {
        "end": {
          "character": 12,
          "line": 0
        },
        "start": {
          "character": 8,
          "line": 0
        }
      },
      "uri": "DIR/L9002"
    }
  }
]
