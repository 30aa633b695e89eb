# Slips in the structure (E0401, E0405, E0406, E0411, E0204) do not keep a program from being executed: hovers, hints and lenses answer.
=== client
{ "capabilities": { "workspace": { "inlayHint": { "refreshSupport": true } } } }
=== open part.nc
‹0›%14
N10 G90 G54 G00 X0 Y0 Z5 R1=7
N20 G71
N30 G04
N40 G73 L77
N40 G72 L9001
N50 G90 G00 X10 ‹Y›Y20 Z5
N60 G71 L10 Q2
N70 ‹X›X‹a›R1‹b› Z50
N80 M30
N500 G79 ‹L›L10
N510 G91 X1
N520 G70
‹E›
=== request textDocument/hover part.nc@Y
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`Y 20 mm`** 2nd axis\n\nlinear axis\n\n---\n\n**N50 runs 1×**\n\n- position after the block: X 10 mm; Y 20 mm; Z 5 mm\n- length of the motion: unknown\n- G functions in force: `G00 G17 G98 G40 G54 G94 G80 G90 G75 G34`\n- M functions after the block: `M05 M40 M09 M53 M48`"
  },
  "range": {
    "end": {
      "character": 19,
      "line": 6
    },
    "start": {
      "character": 16,
      "line": 6
    }
  }
}
=== request textDocument/hover part.nc@X
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`X R1`** 1st axis\n\nlinear axis\n\n---\n\n**N70 runs 1×**\n\n- R1 before the block, as its words read it: 7\n- position after the block: X 19 mm; Y 20 mm; Z 55 mm\n- length of the motion: 50.488 mm\n- G functions in force: `G00 G17 G98 G40 G54 G94 G80 G91 G75 G34`\n- M functions after the block: `M05 M40 M09 M53 M48`"
  },
  "range": {
    "end": {
      "character": 7,
      "line": 8
    },
    "start": {
      "character": 4,
      "line": 8
    }
  }
}
=== request textDocument/inlayHint part.nc@0..E
=== answer
[
  {
    "label": "= 7",
    "paddingLeft": true,
    "position": {
      "character": 7,
      "line": 8
    },
    "tooltip": "R1 before the block: 7"
  },
  {
    "label": "called 2×",
    "paddingLeft": true,
    "position": {
      "character": 12,
      "line": 10
    },
    "tooltip": "How often it is executed in the whole program; every repeat by Q counts."
  }
]
=== request textDocument/codeLens part.nc
=== answer
[
  {
    "command": {
      "command": "",
      "title": "executed blocks: 15, path 52.488 mm"
    },
    "range": {
      "end": {
        "character": 3,
        "line": 0
      },
      "start": {
        "character": 0,
        "line": 0
      }
    }
  },
  {
    "command": {
      "arguments": [
        "DIR/part.nc",
        {
          "character": 5,
          "line": 10
        },
        [
          {
            "range": {
              "end": {
                "character": 3,
                "line": 7
              },
              "start": {
                "character": 0,
                "line": 7
              }
            },
            "uri": "DIR/part.nc"
          }
        ]
      ],
      "command": "cnc872c.showReferences",
      "title": "1 call"
    },
    "range": {
      "end": {
        "character": 8,
        "line": 10
      },
      "start": {
        "character": 5,
        "line": 10
      }
    }
  }
]
