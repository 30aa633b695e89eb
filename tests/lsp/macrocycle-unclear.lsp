# A macrocycle that a function or a number from a parameter may call is not renamed, by its file's name either.
=== client
{
  "locale": "en",
  "capabilities": { "workspace": { "workspaceEdit": { "documentChanges": true, "resourceOperations": ["create", "rename", "delete"] } }, "textDocument": { "rename": { "prepareSupport": true } } }
}
=== file L9001
N10 G79 L9001
N20 G70
=== file L9002
N10 G79 L9002
N20 G70
=== file function.nc
%2
N10 R2=72
N20 GR2 L9001
N30 M30
=== open part.nc
%1
N10 G72 ‹1›L9001
N20 G72 ‹2›L9002
N30 M30
=== request textDocument/rename part.nc@1
{ "newName": "9005" }
=== answer
{
  "code": -32803,
  "message": "what L9001 in block N20 names is known only when the program runs"
}
=== request workspace/willRenameFiles
{ "files": [{ "oldUri": "DIR/L9001", "newUri": "DIR/L9005" }] }
=== answer
null
=== request textDocument/rename part.nc@2
{ "newName": "9006" }
=== answer
{
  "documentChanges": [
    {
      "edits": [
        {
          "newText": "9006",
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
          "newText": "9006",
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
        "uri": "DIR/L9002",
        "version": null
      }
    },
    {
      "kind": "rename",
      "newUri": "DIR/L9006",
      "oldUri": "DIR/L9002"
    }
  ]
}
=== open number.nc
%3
N10 R2=4500 R3=4501
N20 G72 LR2
N30 M30
=== request textDocument/rename part.nc@2
{ "newName": "9007" }
=== answer
{
  "code": -32803,
  "message": "block N20 takes the number of its call from R2: it may call this one"
}
