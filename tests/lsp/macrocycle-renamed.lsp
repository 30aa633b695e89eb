# Macrocycles are found and renamed in all files of the workspace, open or not.
=== client
{
  "locale": "en",
  "capabilities": { "workspace": { "workspaceEdit": { "documentChanges": true, "resourceOperations": ["create", "rename", "delete"] } }, "textDocument": { "rename": { "prepareSupport": true } } }
}
=== file cnc872c.toml
macrocycles = ["macros"]
=== file macros/L9001
N10 G79 L9001
N20 G70
=== file closed.nc
%2
N10 G72 L9001
N20 M30
=== file other.nc
%3
N10 G71 L9001
N20 M30
N30 G79 L9001
N40 G70
=== open part.nc
%1
N10 G72 ‹1›L9001
N20 M30
=== request textDocument/references part.nc@1
{ "context": { "includeDeclaration": true } }
=== answer
[
  {
    "range": {
      "end": {
        "character": 13,
        "line": 1
      },
      "start": {
        "character": 9,
        "line": 1
      }
    },
    "uri": "DIR/part.nc"
  },
  {
    "range": {
      "end": {
        "character": 13,
        "line": 0
      },
      "start": {
        "character": 9,
        "line": 0
      }
    },
    "uri": "DIR/macros/L9001"
  },
  {
    "range": {
      "end": {
        "character": 13,
        "line": 1
      },
      "start": {
        "character": 9,
        "line": 1
      }
    },
    "uri": "DIR/closed.nc"
  }
]
=== request textDocument/prepareRename part.nc@1
=== answer
{
  "placeholder": "9001",
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
=== request textDocument/rename part.nc@1
{ "newName": "L9100" }
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
        "uri": "DIR/macros/L9001",
        "version": null
      }
    },
    {
      "kind": "rename",
      "newUri": "DIR/macros/L9100",
      "oldUri": "DIR/macros/L9001"
    }
  ]
}
=== request workspace/willRenameFiles
{ "files": [{ "oldUri": "DIR/macros/L9001", "newUri": "DIR/macros/L9002" }] }
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
    }
  ]
}
