# All places of a number, in the document, in what it leads to, and in other open programs.
=== file shared/L9001
N1 G79 L9001
N2 G00 XR10
N3 G70
=== file cnc872c.toml
macrocycles = ["shared"]
=== open one.nc
%1
N10 R10=5
N20 G01 X-R‹read›10 YR1 F100
N30 G72 L9001
N40 G73 L‹jump›20 Q3
N50 G73 L0020
N60 G71 L100
N70 M30
N‹n›100 G79 L‹entry›100
N110 G71 L100
N120 G70
=== open two.nc
%2
N10 R10=7
N20 G72 L9001
N30 M30
=== open shared/L9001
N1 G79 L‹macro›9001
N2 G00 XR1‹input›0 G73 L3
N‹own›3 G70
=== request textDocument/references one.nc@read
{ "context": { "includeDeclaration": true } }
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
    "uri": "DIR/one.nc"
  },
  {
    "range": {
      "end": {
        "character": 13,
        "line": 2
      },
      "start": {
        "character": 11,
        "line": 2
      }
    },
    "uri": "DIR/one.nc"
  },
  {
    "range": {
      "end": {
        "character": 11,
        "line": 1
      },
      "start": {
        "character": 9,
        "line": 1
      }
    },
    "uri": "DIR/shared/L9001"
  }
]
=== request textDocument/references one.nc@jump
{ "context": { "includeDeclaration": true } }
=== answer
[
  {
    "range": {
      "end": {
        "character": 3,
        "line": 2
      },
      "start": {
        "character": 1,
        "line": 2
      }
    },
    "uri": "DIR/one.nc"
  },
  {
    "range": {
      "end": {
        "character": 11,
        "line": 4
      },
      "start": {
        "character": 9,
        "line": 4
      }
    },
    "uri": "DIR/one.nc"
  },
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
    "uri": "DIR/one.nc"
  }
]
=== request textDocument/references one.nc@jump
{ "context": { "includeDeclaration": false } }
=== answer
[
  {
    "range": {
      "end": {
        "character": 11,
        "line": 4
      },
      "start": {
        "character": 9,
        "line": 4
      }
    },
    "uri": "DIR/one.nc"
  },
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
    "uri": "DIR/one.nc"
  }
]
=== request textDocument/references one.nc@entry
{ "context": { "includeDeclaration": false } }
=== answer
[
  {
    "range": {
      "end": {
        "character": 12,
        "line": 6
      },
      "start": {
        "character": 9,
        "line": 6
      }
    },
    "uri": "DIR/one.nc"
  },
  {
    "range": {
      "end": {
        "character": 13,
        "line": 9
      },
      "start": {
        "character": 10,
        "line": 9
      }
    },
    "uri": "DIR/one.nc"
  }
]
=== request textDocument/references one.nc@n
{ "context": { "includeDeclaration": false } }
=== answer
[]
=== request textDocument/references shared/L9001@macro
{ "context": { "includeDeclaration": false } }
=== answer
[
  {
    "range": {
      "end": {
        "character": 13,
        "line": 3
      },
      "start": {
        "character": 9,
        "line": 3
      }
    },
    "uri": "DIR/one.nc"
  },
  {
    "range": {
      "end": {
        "character": 13,
        "line": 2
      },
      "start": {
        "character": 9,
        "line": 2
      }
    },
    "uri": "DIR/two.nc"
  }
]
=== request textDocument/references shared/L9001@input
{ "context": { "includeDeclaration": true } }
=== answer
[
  {
    "range": {
      "end": {
        "character": 11,
        "line": 1
      },
      "start": {
        "character": 9,
        "line": 1
      }
    },
    "uri": "DIR/shared/L9001"
  },
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
    "uri": "DIR/one.nc"
  },
  {
    "range": {
      "end": {
        "character": 13,
        "line": 2
      },
      "start": {
        "character": 11,
        "line": 2
      }
    },
    "uri": "DIR/one.nc"
  },
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
    "uri": "DIR/two.nc"
  }
]
=== request textDocument/references shared/L9001@own
{ "context": { "includeDeclaration": true } }
=== answer
[
  {
    "range": {
      "end": {
        "character": 18,
        "line": 1
      },
      "start": {
        "character": 17,
        "line": 1
      }
    },
    "uri": "DIR/shared/L9001"
  },
  {
    "range": {
      "end": {
        "character": 2,
        "line": 2
      },
      "start": {
        "character": 1,
        "line": 2
      }
    },
    "uri": "DIR/shared/L9001"
  }
]
=== request textDocument/documentHighlight one.nc@read
=== answer
[
  {
    "kind": 3,
    "range": {
      "end": {
        "character": 7,
        "line": 1
      },
      "start": {
        "character": 5,
        "line": 1
      }
    }
  },
  {
    "kind": 2,
    "range": {
      "end": {
        "character": 13,
        "line": 2
      },
      "start": {
        "character": 11,
        "line": 2
      }
    }
  }
]
=== request textDocument/documentHighlight one.nc@jump
=== answer
[
  {
    "kind": 3,
    "range": {
      "end": {
        "character": 3,
        "line": 2
      },
      "start": {
        "character": 1,
        "line": 2
      }
    }
  },
  {
    "kind": 2,
    "range": {
      "end": {
        "character": 11,
        "line": 4
      },
      "start": {
        "character": 9,
        "line": 4
      }
    }
  },
  {
    "kind": 2,
    "range": {
      "end": {
        "character": 13,
        "line": 5
      },
      "start": {
        "character": 9,
        "line": 5
      }
    }
  }
]
