# A macrocycle that a parameter leads to is known once the program is executed; the editor is told to ask again.
=== client
{
  "locale": "en",
  "capabilities": { "workspace": { "inlayHint": { "refreshSupport": true } } }
}
=== file L1
N10 G79 L1
N20 R25=5
N30 G70
=== open L1
N10 G79 L1
N20 ‹1›R25=5 XR2
N30 G70
=== open a.nc
%1
N10 R2=1 R3=1 F100 S100 M03 G00 X0 Y0 Z0
N20 G72 LR3
N30 M30
=== findings a.nc
=== said workspace/inlayHint/refresh
null
=== request textDocument/hover L1@1
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`R25 = 5`** parameter R0–R95\n\nholds until changed\n\n---\n\n**N20 runs 1×, in program a\\.nc**\n\n- R25 after the block: 5\n- position after the block: X 1 mm; Y 0 mm; Z 0 mm\n- length of the motion: 1 mm\n- G functions in force: `G00 G17 G98 G40 G53 G94 G80 G90 G75 G34`\n- M functions after the block: `M03 M40 M09 M53 M48`\n- technology: F 100 mm/min; S 100 rev/min"
  },
  "range": {
    "end": {
      "character": 9,
      "line": 1
    },
    "start": {
      "character": 4,
      "line": 1
    }
  }
}
=== request textDocument/codeLens L1
=== answer
[
  {
    "command": {
      "arguments": [
        "DIR/L1",
        {
          "character": 4,
          "line": 0
        },
        []
      ],
      "command": "cnc872c.showReferences",
      "title": "called by a parameter or a fixed cycle"
    },
    "range": {
      "end": {
        "character": 7,
        "line": 0
      },
      "start": {
        "character": 4,
        "line": 0
      }
    }
  }
]
