# A fix that overlaps another waits for a next round; all rounds are one change.
=== client
{ "capabilities": { "textDocument": { "codeAction": { "codeActionLiteralSupport": { "codeActionKind": { "valueSet": [] } } } } } }
=== open part.nc
‹0›%1
N10 G00 RO=5,5 Y0
N20 M30
‹E›
=== request textDocument/codeAction part.nc@0..E
{ "context": { "diagnostics": [], "only": ["source.fixAll.cnc872c"] } }
=== answer
[
  {
    "edit": {
      "changes": {
        "DIR/part.nc": [
          {
            "newText": "N10 G00 R0=5.5 Y0\n",
            "range": {
              "end": {
                "character": 0,
                "line": 2
              },
              "start": {
                "character": 0,
                "line": 1
              }
            }
          }
        ]
      }
    },
    "kind": "source.fixAll.cnc872c",
    "title": "apply all fixes of this file"
  }
]
