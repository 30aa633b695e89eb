# A macrocycle is executed by an open program that leads to it; a client that takes plain text only gets that.
=== client
{ "capabilities": { "textDocument": { "hover": { "contentFormat": ["plaintext"] } } } }
=== open L9001
N1 G79 ‹G79›L9001 "groove"
N2 G91 G01 ‹X›XR1 F1000 R1=R2
N3 G70
=== request textDocument/hover L9001@X
=== answer
{
  "contents": {
    "kind": "plaintext",
    "value": "X R1: 1st axis\nlinear axis\n\nno open program calls this macrocycle: nothing is known of its execution"
  },
  "range": {
    "end": {
      "character": 14,
      "line": 1
    },
    "start": {
      "character": 11,
      "line": 1
    }
  }
}
=== open part.nc
‹0›%1 "plate"
N10 G90 G0 X0 R1=5 R2=7.5
N20 G72 ‹L›L9001 Q2
N30 ‹M›M77
N40 ‹X›X10.‹E›
N50 M30
=== findings part.nc
=== request textDocument/hover L9001@X
=== answer
{
  "contents": {
    "kind": "plaintext",
    "value": "X R1: 1st axis\nlinear axis\n\nN2 runs 2×, in program part.nc\nR1 before the block, as its words read it: 5, 7.5\nposition after the block: X 5, 12.5 mm\nlength of the motion: 5, 7.5 mm\nG functions in force: G01 G17 G98 G40 G53 G94 G80 G91 G75 G34\nM functions after the block: M05 M40 M09 M53 M48\ntechnology: F 1000 mm/min"
  },
  "range": {
    "end": {
      "character": 14,
      "line": 1
    },
    "start": {
      "character": 11,
      "line": 1
    }
  }
}
=== request textDocument/hover L9001@G79
=== answer
{
  "contents": {
    "kind": "plaintext",
    "value": "L9001: number of a subprogram or macrocycle, or the block to jump to\n\nN1 runs 2×, in program part.nc\nposition after the block: X 0, 5 mm\nG functions in force: G00/G01 G17 G98 G40 G53 G94 G79 G80 G90/G91 G75 G34\nM functions after the block: M05 M40 M09 M53 M48\ntechnology: F 1000, ? mm/min"
  },
  "range": {
    "end": {
      "character": 12,
      "line": 0
    },
    "start": {
      "character": 7,
      "line": 0
    }
  }
}
=== request textDocument/hover part.nc@L
=== answer
{
  "contents": {
    "kind": "plaintext",
    "value": "L9001: number of a subprogram or macrocycle, or the block to jump to\ncalls macrocycle L9001, 2×\ntarget: N1 G79 L9001 in L9001\ngroove\ntakes: R1 = 5; R2 = 7.5\n\nN20 runs 1×\nposition after the block: X 0 mm\nG functions in force: G00 G17 G98 G40 G53 G94 G72 G80 G90 G75 G34\nM functions after the block: M05 M40 M09 M53 M48"
  },
  "range": {
    "end": {
      "character": 13,
      "line": 2
    },
    "start": {
      "character": 8,
      "line": 2
    }
  }
}
=== request textDocument/hover part.nc@M
=== answer
{
  "contents": {
    "kind": "plaintext",
    "value": "M77: technological function\nwhat it does is up to the machine builder; group 14 of the M functions; holds until another function of its group\nthe PLC reads: BLK.M[14]=77h BLK.M14=1 ZMM14PI=1 PB16=77h\n\nN30 runs 1×\nposition after the block: X 12.5 mm\nG functions in force: G01 G17 G98 G40 G53 G94 G80 G91 G75 G34\nM functions after the block: M05 M40 M09 M53 M48 M77\ntechnology: F 1000 mm/min"
  },
  "range": {
    "end": {
      "character": 7,
      "line": 3
    },
    "start": {
      "character": 4,
      "line": 3
    }
  }
}
=== request textDocument/hover part.nc@0
=== answer
{
  "contents": {
    "kind": "plaintext",
    "value": "%1: program number\n“plate”\naxes: X, Y, Z, A, B, C, U, V, W\nexecuted blocks: 11\npath: 22.5 mm\nend: M30"
  },
  "range": {
    "end": {
      "character": 2,
      "line": 0
    },
    "start": {
      "character": 0,
      "line": 0
    }
  }
}
=== replace part.nc X E
X10,5
=== findings part.nc
4:4-4:9 E0104 a decimal comma | help: the control knows the decimal point only: write `X10.5`
=== request textDocument/hover part.nc@X
=== answer
{
  "contents": {
    "kind": "plaintext",
    "value": "X 10.5 mm: 1st axis\nlinear axis\n\nN40 runs 1×\nposition after the block: X 23 mm\nlength of the motion: 10.5 mm\nG functions in force: G01 G17 G98 G40 G53 G94 G80 G91 G75 G34\nM functions after the block: M05 M40 M09 M53 M48 M77\ntechnology: F 1000 mm/min"
  },
  "range": {
    "end": {
      "character": 9,
      "line": 4
    },
    "start": {
      "character": 4,
      "line": 4
    }
  }
}
