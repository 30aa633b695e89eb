# The number of a new block after a line end; nothing where the line is no new block.
=== open part.nc
%1 "flange"
N10 G00 X0
‹1›
N20 G01 F100 X1
‹2›
 Y5
N30 M30
‹3›
=== request textDocument/onTypeFormatting part.nc@1
{ "ch": "\n", "options": { "tabSize": 4, "insertSpaces": true } }
=== answer
[
  {
    "newText": "N15 ",
    "range": {
      "end": {
        "character": 0,
        "line": 2
      },
      "start": {
        "character": 0,
        "line": 2
      }
    }
  }
]
=== edited
--- part.nc
%1 "flange"
N10 G00 X0
N15 
N20 G01 F100 X1

 Y5
N30 M30

=== request textDocument/onTypeFormatting part.nc@2
{ "ch": "\n", "options": { "tabSize": 4, "insertSpaces": true } }
=== answer
null
=== request textDocument/onTypeFormatting part.nc@3
{ "ch": "\n", "options": { "tabSize": 4, "insertSpaces": true } }
=== answer
null
