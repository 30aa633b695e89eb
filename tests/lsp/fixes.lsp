# Fixes of findings in the range, and all of them.
=== client
{
  "locale": "cs",
  "capabilities": {
    "textDocument": { "codeAction": { "codeActionLiteralSupport": { "codeActionKind": { "valueSet": [] } } } },
    "workspace": { "workspaceEdit": { "documentChanges": true } }
  }
}
=== open part.nc
%1
N10 ‹1›X5,5 Y2,5
‹2›N20 X-O
/N30 X1
N40 M30
=== request textDocument/codeAction part.nc@1..1
{ "context": { "diagnostics": [], "only": ["quickfix"] } }
=== answer
[
  {
    "diagnostics": [
      {
        "code": "E0104",
        "codeDescription": {
          "href": "cnc872c:/explain/cs/E0104.md"
        },
        "message": "desetinná čárka\nnápověda: systém zná jen desetinnou tečku: napsat „X5.5“",
        "range": {
          "end": {
            "character": 8,
            "line": 1
          },
          "start": {
            "character": 4,
            "line": 1
          }
        },
        "severity": 1,
        "source": "cnc872c"
      }
    ],
    "edit": {
      "documentChanges": [
        {
          "edits": [
            {
              "newText": "X5.5",
              "range": {
                "end": {
                  "character": 8,
                  "line": 1
                },
                "start": {
                  "character": 4,
                  "line": 1
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
    },
    "isPreferred": true,
    "kind": "quickfix",
    "title": "napsat „X5.5“"
  }
]
=== edited
--- part.nc
%1
N10 X5.5 Y2,5
N20 X-O
/N30 X1
N40 M30
=== request textDocument/codeAction part.nc@2..2
{ "context": { "diagnostics": [], "triggerKind": 2 } }
=== answer
[]
=== request textDocument/codeAction part.nc@1..1
{ "context": { "diagnostics": [], "only": ["source.fixAll"] } }
=== answer
[
  {
    "edit": {
      "documentChanges": [
        {
          "edits": [
            {
              "newText": "X5.5",
              "range": {
                "end": {
                  "character": 8,
                  "line": 1
                },
                "start": {
                  "character": 4,
                  "line": 1
                }
              }
            },
            {
              "newText": "Y2.5",
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
              "newText": "X-0",
              "range": {
                "end": {
                  "character": 7,
                  "line": 2
                },
                "start": {
                  "character": 4,
                  "line": 2
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
    },
    "kind": "source.fixAll.cnc872c",
    "title": "použít všechny opravy v tomto souboru"
  }
]
=== edited
--- part.nc
%1
N10 X5.5 Y2.5
N20 X-0
/N30 X1
N40 M30
=== request textDocument/codeAction part.nc@1..1
{ "context": { "diagnostics": [], "only": ["refactor"] } }
=== answer
[]
