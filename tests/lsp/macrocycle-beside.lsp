# Without a folder of a workspace, what lies beside an open program or the macrocycle follows a renaming too.
=== client
{
  "locale": "en",
  "workspaceFolders": null,
  "rootUri": null,
  "capabilities": { "workspace": { "workspaceEdit": { "documentChanges": true, "resourceOperations": ["create", "rename", "delete"] } }, "textDocument": { "rename": { "prepareSupport": true } } }
}
=== file L9001
N10 G79 L9001
N20 G70
=== file closed.nc
%2
N10 G72 L9001
N20 M30
=== open part.nc
%1
N10 G72 ‹1›L9001
N20 M30
=== request textDocument/rename part.nc@1
{ "newName": "9005" }
=== answer
{
  "documentChanges": [
    {
      "edits": [
        {
          "newText": "9005",
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
          "newText": "9005",
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
        "uri": "DIR/L9001",
        "version": null
      }
    },
    {
      "edits": [
        {
          "newText": "9005",
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
        }
      ],
      "textDocument": {
        "uri": "DIR/closed.nc",
        "version": null
      }
    },
    {
      "kind": "rename",
      "newUri": "DIR/L9005",
      "oldUri": "DIR/L9001"
    }
  ]
}
