# PAR-5: where execution cannot be followed, nothing is said of how often what comes after it runs.
=== open part.nc
‹0›%1
N10 G71 L7 QR1
N15 G71 L8
N20 M30
N30 G79 L7
N40 G70
N50 G79 L8
N60 ‹X›X5 G70
‹E›
=== findings part.nc
1:11-1:14 W0503 R1 is read before the program gives it a value | note: its value comes from the machine's parameter table: what depends on it is not checked | help: assign it first: `R1=…`, or give the machine's value with `--param R1=…`
=== request textDocument/hover part.nc@X
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`X 5 mm`** 1st axis\n\nlinear axis\n\n---\n\n**how often N60 runs is not known, execution can be followed up to N10 only**"
  },
  "range": {
    "end": {
      "character": 6,
      "line": 7
    },
    "start": {
      "character": 4,
      "line": 7
    }
  }
}
=== request textDocument/inlayHint part.nc@0..E
=== answer
[]
