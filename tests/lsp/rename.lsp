# Another number for a block, a subprogram, a parameter; versions of documents for clients that take them.
=== file cnc872c.toml
[operations]
1 = "add"
=== client
{ "capabilities": { "workspace": { "workspaceEdit": { "documentChanges": true } }, "textDocument": { "rename": { "prepareSupport": true } } } }
=== open part.nc
%306
N10 R10=5 R9=1
N‹n›20 G01 XR‹r›10 F100
N30 G26 R5=1091010
N40 G73 L‹jump›0020 Q3
N50 G‹function›73 L20
N60 G71 L‹sub›100
N70 M30
N100 G79 L100
N110 G00 Y-R10
N120 G70
=== request textDocument/prepareRename part.nc@n
=== answer
{
  "placeholder": "20",
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
}
=== request textDocument/prepareRename part.nc@function
=== answer
null
=== request textDocument/rename part.nc@jump
{ "newName": "N025" }
=== answer
{
  "documentChanges": [
    {
      "edits": [
        {
          "newText": "025",
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
          "newText": "025",
          "range": {
            "end": {
              "character": 13,
              "line": 4
            },
            "start": {
              "character": 9,
              "line": 4
            }
          }
        },
        {
          "newText": "025",
          "range": {
            "end": {
              "character": 11,
              "line": 5
            },
            "start": {
              "character": 9,
              "line": 5
            }
          }
        }
      ],
      "textDocument": {
        "uri": "DIR/part.nc",
        "version": 1
      }
    }
  ]
}
=== edited
--- part.nc
%306
N10 R10=5 R9=1
N025 G01 XR10 F100
N30 G26 R5=1091010
N40 G73 L025 Q3
N50 G73 L025
N60 G71 L100
N70 M30
N100 G79 L100
N110 G00 Y-R10
N120 G70
=== request textDocument/rename part.nc@sub
{ "newName": "7" }
=== edited
--- part.nc
%306
N10 R10=5 R9=1
N20 G01 XR10 F100
N30 G26 R5=1091010
N40 G73 L0020 Q3
N50 G73 L20
N60 G71 L7
N70 M30
N100 G79 L7
N110 G00 Y-R10
N120 G70
=== request textDocument/rename part.nc@r
{ "newName": "7" }
=== answer
{
  "code": -32803,
  "message": "R7 holds the control word of G26–G29"
}
=== request textDocument/rename part.nc@r
{ "newName": "R3" }
=== edited
--- part.nc
%306
N10 R3=5 R9=1
N20 G01 XR3 F100
N30 G26 R5=1090303
N40 G73 L0020 Q3
N50 G73 L20
N60 G71 L100
N70 M30
N100 G79 L100
N110 G00 Y-R3
N120 G70
