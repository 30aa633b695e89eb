# A macrocycle is renamed; another file of that number, which no call leads to, keeps its header.
=== client
{
  "locale": "en",
  "capabilities": { "workspace": { "workspaceEdit": { "documentChanges": true, "resourceOperations": ["create", "rename", "delete"] } }, "textDocument": { "rename": { "prepareSupport": true } } }
}
=== file cnc872c.toml
macrocycles = ["shared"]
=== file shared/L9001
N10 G79 L9001
N20 G70
=== file a/L9001
N10 G79 L9001
N20 G70
=== open part.nc
%1
N10 G72 ‹1›L9001
N20 M30
=== request textDocument/rename part.nc@1
{ "newName": "9100" }
=== answer
{
  "documentChanges": [
    {
      "edits": [
        {
          "newText": "9100",
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
          "newText": "9100",
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
        "uri": "DIR/shared/L9001",
        "version": null
      }
    },
    {
      "kind": "rename",
      "newUri": "DIR/shared/L9100",
      "oldUri": "DIR/shared/L9001"
    }
  ]
}
