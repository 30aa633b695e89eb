# Where motion is configured, hovers say how the machine moves through a block, and lenses how long that takes.
=== client
{ "locale": "en" }
=== file cnc872c.toml
[motion]
cycle-ms = 2
accuracy-um = 8
=== open part.nc
%14
N10 G90 G0 X0 Y0 Z5
N20 G23 G1 X60 F3000
N30 X‹slow›80 Y4
N40 X80 Y60‹stop›
N50 G71 L10 Q2
N60 M30
N500 G79 L10
N510 G1 Z-1 F120
N520 Z5 G70
=== request textDocument/hover part.nc@slow
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`X 80 mm`** 1st axis\n\nlinear axis\n\n---\n\n**N30 runs 1×**\n\n- position after the block: X 80 mm; Y 4 mm; Z 5 mm\n- length of the motion: 20.396 mm\n- G functions in force: `G01 G17 G23 G40 G53 G94 G80 G90 G75 G34`\n- M functions after the block: `M05 M40 M09 M53 M48`\n- technology: F 3000 mm/min\n- velocity at the start / greatest / at the end: 2423.8 / 3000 / 0 mm/min\n- joint with the motion before: limited by: criterion of accuracy\n- time: 0.459766 s"
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
=== request textDocument/hover part.nc@stop
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`Y 60 mm`** 2nd axis\n\nlinear axis\n\n---\n\n**N40 runs 1×**\n\n- position after the block: X 80 mm; Y 60 mm; Z 5 mm\n- length of the motion: 56 mm\n- G functions in force: `G01 G17 G23 G40 G53 G94 G80 G90 G75 G34`\n- M functions after the block: `M05 M40 M09 M53 M48`\n- technology: F 3000 mm/min\n- velocity at the start / greatest / at the end: 0 / 3000 / 0 mm/min\n- joint with the motion before: stop: angle\n- time: 1.22 s"
  },
  "range": {
    "end": {
      "character": 11,
      "line": 4
    },
    "start": {
      "character": 8,
      "line": 4
    }
  }
}
=== request textDocument/codeLens part.nc
=== answer
[
  {
    "command": {
      "command": "",
      "title": "executed blocks: 12, path 160.396 mm, time 0:00:14.9 without the approach"
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
          "line": 7
        },
        [
          {
            "range": {
              "end": {
                "character": 3,
                "line": 5
              },
              "start": {
                "character": 0,
                "line": 5
              }
            },
            "uri": "DIR/part.nc"
          }
        ]
      ],
      "command": "cnc872c.showReferences",
      "title": "1 call, time 0:00:12.0"
    },
    "range": {
      "end": {
        "character": 8,
        "line": 7
      },
      "start": {
        "character": 5,
        "line": 7
      }
    }
  }
]
=== request cnc872c/dots part.nc
=== answer
[
  {
    "dot": "red",
    "line": 2
  },
  {
    "dot": "yellow",
    "line": 3
  },
  {
    "dot": "red",
    "line": 4
  },
  {
    "dot": "red",
    "line": 8
  },
  {
    "dot": "red",
    "line": 9
  }
]
