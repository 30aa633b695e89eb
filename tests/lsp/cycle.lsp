# GRP-6: a macrocycle that a fixed cycle calls shows its execution too.
=== file cnc872c.toml
[cycles]
G81 = 8100
=== open L8100
N1 G79 ‹L›L8100
N2 G91 G01 ‹Z›Z-1 F100
N3 G90 G70
=== open part.nc
%1
N10 G90 G00 X0 Y0 Z5
N20 G81 X10
N30 X20
N40 G80 M30
=== findings part.nc
=== request textDocument/hover L8100@Z
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`Z -1 mm`** 3rd axis\n\nlinear axis\n\n---\n\n**N2 runs 2×, in program part\\.nc**\n\n- position after the block: X 10, 20 mm; Y 0 mm; Z 4, 3 mm\n- length of the motion: 1 mm\n- G functions in force: `G01 G17 G98 G40 G53 G94 G80 G91 G75 G34`\n- M functions after the block: `M05 M40 M09 M53 M48`\n- technology: F 100 mm/min"
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
=== request textDocument/inlayHint L8100@L..Z
=== answer
[
  {
    "label": "called 2×",
    "paddingLeft": true,
    "position": {
      "character": 12,
      "line": 0
    },
    "tooltip": "How often it is executed in the whole program; every repeat by Q counts."
  }
]
