# One layout for a document, for the blocks of a selection, and for the line that Enter leaves (FMT-1 to FMT-6).
=== file cnc872c.toml
[format]
codes = "short"
=== open part.nc
%1 "flange"

‹d›

N10 G00 X0
n20  g01 ‹a›X1   F100 "řez"
  ‹b›  Y5
‹c›N30 X-  5
N40 R1 = 5‹e›
‹f›
N50 M30
=== request textDocument/formatting part.nc
{ "options": { "tabSize": 4, "insertSpaces": true } }
=== answer
[
  {
    "newText": "\n\n",
    "range": {
      "end": {
        "character": 0,
        "line": 4
      },
      "start": {
        "character": 11,
        "line": 0
      }
    }
  },
  {
    "newText": "G0",
    "range": {
      "end": {
        "character": 7,
        "line": 4
      },
      "start": {
        "character": 4,
        "line": 4
      }
    }
  },
  {
    "newText": "N20",
    "range": {
      "end": {
        "character": 3,
        "line": 5
      },
      "start": {
        "character": 0,
        "line": 5
      }
    }
  },
  {
    "newText": " ",
    "range": {
      "end": {
        "character": 5,
        "line": 5
      },
      "start": {
        "character": 3,
        "line": 5
      }
    }
  },
  {
    "newText": "G1",
    "range": {
      "end": {
        "character": 8,
        "line": 5
      },
      "start": {
        "character": 5,
        "line": 5
      }
    }
  },
  {
    "newText": " ",
    "range": {
      "end": {
        "character": 14,
        "line": 5
      },
      "start": {
        "character": 11,
        "line": 5
      }
    }
  },
  {
    "newText": "  ",
    "range": {
      "end": {
        "character": 4,
        "line": 6
      },
      "start": {
        "character": 0,
        "line": 6
      }
    }
  },
  {
    "newText": "R1=5",
    "range": {
      "end": {
        "character": 10,
        "line": 8
      },
      "start": {
        "character": 4,
        "line": 8
      }
    }
  }
]
=== edited
--- part.nc
%1 "flange"

N10 G0 X0
N20 G1 X1 F100 "řez"
  Y5
N30 X-  5
N40 R1=5

N50 M30
=== request textDocument/rangeFormatting part.nc@b..c
{ "options": { "tabSize": 4, "insertSpaces": true } }
=== answer
[
  {
    "newText": "N20",
    "range": {
      "end": {
        "character": 3,
        "line": 5
      },
      "start": {
        "character": 0,
        "line": 5
      }
    }
  },
  {
    "newText": " ",
    "range": {
      "end": {
        "character": 5,
        "line": 5
      },
      "start": {
        "character": 3,
        "line": 5
      }
    }
  },
  {
    "newText": "G1",
    "range": {
      "end": {
        "character": 8,
        "line": 5
      },
      "start": {
        "character": 5,
        "line": 5
      }
    }
  },
  {
    "newText": " ",
    "range": {
      "end": {
        "character": 14,
        "line": 5
      },
      "start": {
        "character": 11,
        "line": 5
      }
    }
  },
  {
    "newText": "  ",
    "range": {
      "end": {
        "character": 4,
        "line": 6
      },
      "start": {
        "character": 0,
        "line": 6
      }
    }
  }
]
=== edited
--- part.nc
%1 "flange"



N10 G00 X0
N20 G1 X1 F100 "řez"
  Y5
N30 X-  5
N40 R1 = 5

N50 M30
=== request textDocument/onTypeFormatting part.nc@f
{ "ch": "\n", "options": { "tabSize": 4, "insertSpaces": true } }
=== answer
[
  {
    "newText": "R1=5",
    "range": {
      "end": {
        "character": 10,
        "line": 8
      },
      "start": {
        "character": 4,
        "line": 8
      }
    }
  },
  {
    "newText": "N45 ",
    "range": {
      "end": {
        "character": 0,
        "line": 9
      },
      "start": {
        "character": 0,
        "line": 9
      }
    }
  }
]
=== edited
--- part.nc
%1 "flange"



N10 G00 X0
n20  g01 X1   F100 "řez"
    Y5
N30 X-  5
N40 R1=5
N45 
N50 M30
=== text part.nc
%1 "flange"
N10 G0 X0
=== request textDocument/formatting part.nc
{ "options": { "tabSize": 4, "insertSpaces": true } }
=== answer
[]
=== text part.nc
% fanuc
O0001 (PART)
G21 G90 G54
G43 H1 Z50.
#100=5
M30
%
=== request textDocument/formatting part.nc
{ "options": { "tabSize": 4, "insertSpaces": true } }
=== answer
null
