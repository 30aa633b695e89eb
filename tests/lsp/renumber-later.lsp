# A client that fetches edits when they are wanted.
=== client
{
  "locale": "cs",
  "capabilities": {
    "textDocument": {
      "codeAction": {
        "codeActionLiteralSupport": { "codeActionKind": { "valueSet": [] } },
        "dataSupport": true,
        "resolveSupport": { "properties": ["edit"] }
      }
    }
  }
}
=== open L9001
‹1›N1 G79 L9001
N2 X1
N3 G73 L2 Q4
N4 G70
=== request textDocument/codeAction L9001@1..1
{ "context": { "diagnostics": [], "only": ["source"] } }
=== answer
[
  {
    "data": {
      "uri": "DIR/L9001",
      "version": 1
    },
    "kind": "source.renumber.cnc872c",
    "title": "přečíslovat bloky po 10"
  }
]
=== request codeAction/resolve
{ "title": "x", "kind": "source.renumber.cnc872c", "data": { "uri": "DIR/L9001", "version": 1 } }
=== answer
{
  "data": {
    "uri": "DIR/L9001",
    "version": 1
  },
  "edit": {
    "changes": {
      "DIR/L9001": [
        {
          "newText": "10",
          "range": {
            "end": {
              "character": 2,
              "line": 0
            },
            "start": {
              "character": 1,
              "line": 0
            }
          }
        },
        {
          "newText": "20",
          "range": {
            "end": {
              "character": 2,
              "line": 1
            },
            "start": {
              "character": 1,
              "line": 1
            }
          }
        },
        {
          "newText": "30",
          "range": {
            "end": {
              "character": 2,
              "line": 2
            },
            "start": {
              "character": 1,
              "line": 2
            }
          }
        },
        {
          "newText": "20",
          "range": {
            "end": {
              "character": 9,
              "line": 2
            },
            "start": {
              "character": 8,
              "line": 2
            }
          }
        },
        {
          "newText": "40",
          "range": {
            "end": {
              "character": 2,
              "line": 3
            },
            "start": {
              "character": 1,
              "line": 3
            }
          }
        }
      ]
    }
  },
  "kind": "source.renumber.cnc872c",
  "title": "x"
}
=== edited
--- L9001
N10 G79 L9001
N20 X1
N30 G73 L20 Q4
N40 G70
=== request codeAction/resolve
{ "title": "x", "kind": "source.renumber.cnc872c", "data": { "uri": "DIR/L9001", "version": 0 } }
=== answer
{
  "code": -32801,
  "message": "the document has changed"
}
