# A macrocycle gets no number that other calls, the machine or the cycle map name already, by its file's name either.
=== client
{
  "locale": "en",
  "capabilities": { "workspace": { "workspaceEdit": { "documentChanges": true, "resourceOperations": ["create", "rename", "delete"] } }, "textDocument": { "rename": { "prepareSupport": true } } }
}
=== file cnc872c.toml
macrocycles = ["macros", "more"]
[machine-macrocycles]
L9005 = { axes = ["Z"] }
[cycles]
G81 = 9003
=== file macros/L9001
N10 G79 L9001
N20 G70
=== file macros/L9002.NC
N10 G79 L9002
N20 G70
=== file macros/L9003
N10 G79 L9003
N20 G70
=== file more/l9004
N10 G79 L9004
N20 G70
=== file closed.nc
%2
N10 G72 L9007
N20 G72 L9005
N30 G72 L9003
N40 M30
=== open part.nc
%1
N10 G72 ‹1›L9001
N20 G72 L9002
N30 M30
=== request textDocument/rename part.nc@1
{ "newName": "9005" }
=== answer
{
  "code": -32803,
  "message": "macrocycle L9005 exists already"
}
=== request textDocument/rename part.nc@1
{ "newName": "9004" }
=== answer
{
  "code": -32803,
  "message": "macrocycle L9004 exists already"
}
=== request textDocument/rename part.nc@1
{ "newName": "9007" }
=== answer
{
  "code": -32803,
  "message": "L9007 (closed.nc) leads nowhere now and would then lead here"
}
=== request textDocument/rename part.nc@1
{ "newName": "9002" }
=== answer
{
  "code": -32803,
  "message": "macrocycle L9002 exists already"
}
=== request workspace/willRenameFiles
{ "files": [{ "oldUri": "DIR/macros/L9001", "newUri": "DIR/macros/L9005" }] }
=== answer
null
=== request workspace/willRenameFiles
{ "files": [{ "oldUri": "DIR/macros/L9001", "newUri": "DIR/macros/L9007" }] }
=== answer
null
=== request workspace/willRenameFiles
{ "files": [{ "oldUri": "DIR/macros/L9001", "newUri": "DIR/macros/L9002" }] }
=== answer
null
=== request workspace/willRenameFiles
{ "files": [{ "oldUri": "DIR/macros/L9003", "newUri": "DIR/macros/L9008" }] }
=== answer
null
=== request workspace/willRenameFiles
{ "files": [{ "oldUri": "DIR/macros/L9001", "newUri": "DIR/macros/L9002" }, { "oldUri": "DIR/macros/L9002.NC", "newUri": "DIR/macros/L9001.NC" }] }
=== answer
{
  "documentChanges": [
    {
      "edits": [
        {
          "newText": "9002",
          "range": {
            "end": {
              "character": 13,
              "line": 1
            },
            "start": {
              "character": 9,
              "line": 1
            }
          }
        },
        {
          "newText": "9001",
          "range": {
            "end": {
              "character": 13,
              "line": 2
            },
            "start": {
              "character": 9,
              "line": 2
            }
          }
        }
      ],
      "textDocument": {
        "uri": "DIR/part.nc",
        "version": 1
      }
    },
    {
      "edits": [
        {
          "newText": "9002",
          "range": {
            "end": {
              "character": 13,
              "line": 0
            },
            "start": {
              "character": 9,
              "line": 0
            }
          }
        }
      ],
      "textDocument": {
        "uri": "DIR/macros/L9001",
        "version": null
      }
    },
    {
      "edits": [
        {
          "newText": "9001",
          "range": {
            "end": {
              "character": 13,
              "line": 0
            },
            "start": {
              "character": 9,
              "line": 0
            }
          }
        }
      ],
      "textDocument": {
        "uri": "DIR/macros/L9002.NC",
        "version": null
      }
    }
  ]
}
