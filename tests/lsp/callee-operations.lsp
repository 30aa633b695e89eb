# What an operation computes is no value that the macrocycle takes, where the next operation of the block reads it.
=== client
{
  "locale": "en",
  "capabilities": {}
}
=== file cnc872c.toml
[operations]
"01" = "add"
=== file L1
N10 G79 L1
N20 G27 R5=01101140 R6=01401141 G01 X1 F100
N30 R40=1 XR12
N40 G70
=== open a.nc
%1
N10 R10=1 R11=2 G72 ‹1›L1
N20 M30
=== request textDocument/hover a.nc@1
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`L1`** number of a subprogram or macrocycle, or the block to jump to\n\ncalls macrocycle L1\n\n- target: `N10 G79 L1` in `L1`\n- takes: R10 = 1; R11 = 2; R12\n\n---\n\n**N10 runs 1×**\n\n- R10 after the block: 1\n- R11 after the block: 2\n- position after the block: unknown\n- G functions in force: `G00 G17 G98 G40 G53 G94 G72 G80 G90 G75 G34`\n- M functions after the block: `M05 M40 M09 M53 M48`"
  },
  "range": {
    "end": {
      "character": 22,
      "line": 1
    },
    "start": {
      "character": 20,
      "line": 1
    }
  }
}
