# Changes that are offered, not applied by themselves: of the program, of the project file.
=== client
{
  "locale": "en",
  "capabilities": {
    "textDocument": { "codeAction": { "codeActionLiteralSupport": { "codeActionKind": { "valueSet": [] } } } },
    "workspace": { "workspaceEdit": { "documentChanges": true, "resourceOperations": ["create", "rename", "delete"] } }
  }
}
=== open cnc872c.toml
dialec‹1›t = "cnc8x9"
block-skip = false
=== open part.nc
%1
N10 G71 L‹1›110
N20 G72 L9001
‹3›N30
N40 M30
N50 G79 L100
N60 G0 X1
N70 G70
=== request textDocument/codeAction part.nc@1..1
{ "context": { "diagnostics": [], "only": ["quickfix"] } }
=== answer
[
  {
    "diagnostics": [
      {
        "code": "E0404",
        "codeDescription": {
          "href": "cnc872c:/explain/en/E0404.md"
        },
        "message": "there is no subprogram L110 in this file\nhelp: the nearest one is `G71 L100`",
        "range": {
          "end": {
            "character": 12,
            "line": 1
          },
          "start": {
            "character": 9,
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
              "newText": "100",
              "range": {
                "end": {
                  "character": 12,
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
        }
      ]
    },
    "kind": "quickfix",
    "title": "write `G71 L100`"
  }
]
=== request textDocument/codeAction part.nc@3..3
{ "context": { "diagnostics": [], "only": ["quickfix"] } }
=== answer
[
  {
    "diagnostics": [
      {
        "code": "W0214",
        "codeDescription": {
          "href": "cnc872c:/explain/en/W0214.md"
        },
        "message": "block N30 is empty\nhelp: delete it, or say in a comment what it is for",
        "range": {
          "end": {
            "character": 3,
            "line": 3
          },
          "start": {
            "character": 0,
            "line": 3
          }
        },
        "severity": 2,
        "source": "cnc872c",
        "tags": [
          1
        ]
      }
    ],
    "edit": {
      "documentChanges": [
        {
          "edits": [
            {
              "newText": "",
              "range": {
                "end": {
                  "character": 0,
                  "line": 4
                },
                "start": {
                  "character": 0,
                  "line": 3
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
    "kind": "quickfix",
    "title": "delete N30"
  },
  {
    "diagnostics": [
      {
        "code": "W0214",
        "codeDescription": {
          "href": "cnc872c:/explain/en/W0214.md"
        },
        "message": "block N30 is empty\nhelp: delete it, or say in a comment what it is for",
        "range": {
          "end": {
            "character": 3,
            "line": 3
          },
          "start": {
            "character": 0,
            "line": 3
          }
        },
        "severity": 2,
        "source": "cnc872c",
        "tags": [
          1
        ]
      }
    ],
    "edit": {
      "documentChanges": [
        {
          "edits": [
            {
              "newText": "\n[lints]\nempty-block = \"allow\"\n",
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
          ],
          "textDocument": {
            "uri": "DIR/cnc872c.toml",
            "version": 1
          }
        }
      ]
    },
    "kind": "quickfix",
    "title": "allow `empty-block` in cnc872c.toml"
  }
]
=== text cnc872c.toml
‹1›dialec = "cnc8x9"
=== request textDocument/codeAction cnc872c.toml@1..1
{ "context": { "diagnostics": [] } }
=== answer
[
  {
    "diagnostics": [
      {
        "code": "W0705",
        "codeDescription": {
          "href": "cnc872c:/explain/en/W0705.md"
        },
        "message": "unknown key `dialec`\nnote: the run goes on for cnc872, unless --dialect says otherwise\nhelp: perhaps `dialect` is meant",
        "range": {
          "end": {
            "character": 6,
            "line": 0
          },
          "start": {
            "character": 0,
            "line": 0
          }
        },
        "severity": 2,
        "source": "cnc872c"
      }
    ],
    "edit": {
      "documentChanges": [
        {
          "edits": [
            {
              "newText": "dialect",
              "range": {
                "end": {
                  "character": 6,
                  "line": 0
                },
                "start": {
                  "character": 0,
                  "line": 0
                }
              }
            }
          ],
          "textDocument": {
            "uri": "DIR/cnc872c.toml",
            "version": 2
          }
        }
      ]
    },
    "kind": "quickfix",
    "title": "write `dialect`"
  }
]
=== edited
--- cnc872c.toml
dialect = "cnc8x9"
--- part.nc
%1
N10 G71 L110
N20 G72 L9001
N30
N40 M30
N50 G79 L100
N60 G0 X1
N70 G70
