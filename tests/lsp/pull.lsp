# A client that fetches findings gets those of open documents only so; those of other files are sent, and it is asked to
# fetch again when another file changes them.
=== client
{ "capabilities": { "textDocument": { "diagnostic": {} }, "workspace": { "diagnostics": { "refreshSupport": true } } } }
=== file L9001
N1 G79 L9001
N2 X5,5
N3 G70
=== open part.nc
%1
N10 G72 L9001
N20 X1 X2
N30 M30
=== findings L9001
1:3-1:7 E0104 a decimal comma | help: the control knows the decimal point only: write `X5.5`
=== request textDocument/diagnostic part.nc
=== answer
{
  "items": [
    {
      "code": "E0306",
      "codeDescription": {
        "href": "cnc872c:/explain/en/E0306.md"
      },
      "message": "`X` is written twice in this block\nhelp: keep one of them, or begin a new block with `N…`",
      "range": {
        "end": {
          "character": 9,
          "line": 2
        },
        "start": {
          "character": 7,
          "line": 2
        }
      },
      "relatedInformation": [
        {
          "location": {
            "range": {
              "end": {
                "character": 6,
                "line": 2
              },
              "start": {
                "character": 4,
                "line": 2
              }
            },
            "uri": "DIR/part.nc"
          },
          "message": "`X1` is the first one"
        }
      ],
      "severity": 1,
      "source": "cnc872c"
    }
  ],
  "kind": "full",
  "resultId": "2"
}
=== request textDocument/diagnostic part.nc
{ "previousResultId": "2" }
=== answer
{
  "kind": "unchanged",
  "resultId": "2"
}
=== open cnc872c.toml
[lints]
W0214 = "deny"
=== said workspace/diagnostic/refresh
null
=== text part.nc
%1
N10
N20 M30
=== request textDocument/diagnostic part.nc
=== answer
{
  "items": [
    {
      "code": "W0214",
      "codeDescription": {
        "href": "cnc872c:/explain/en/W0214.md"
      },
      "message": "block N10 is empty\nhelp: delete it, or say in a comment what it is for",
      "range": {
        "end": {
          "character": 3,
          "line": 1
        },
        "start": {
          "character": 0,
          "line": 1
        }
      },
      "severity": 1,
      "source": "cnc872c",
      "tags": [
        1
      ]
    }
  ],
  "kind": "full",
  "resultId": "4"
}
