# Inside words: an item takes the place of the whole number, a letter alone takes none away, `=` is not written twice, and
# a number that something touches counts as taken.
=== client
{ "capabilities": {} }
=== file cnc872c.toml
=== open a.nc
%1
N10 G0 X‹1›05.500 F200
N20 G1 X‹2› 5 F‹3›1.5 R11=2
N30 XR‹4›1 YR11
N40 R‹5›11=3
N50N‹6›
N60 M30
=== request textDocument/completion a.nc@1
=== answer
{
  "isIncomplete": false,
  "items": []
}
=== request textDocument/completion a.nc@2
=== answer
{
  "isIncomplete": false,
  "items": []
}
=== request textDocument/completion a.nc@3
=== answer
{
  "isIncomplete": false,
  "items": [
    {
      "detail": "1× in the program",
      "filterText": "F200",
      "kind": 12,
      "label": "F200",
      "sortText": "00000000000",
      "textEdit": {
        "newText": "F200",
        "range": {
          "end": {
            "character": 15,
            "line": 2
          },
          "start": {
            "character": 11,
            "line": 2
          }
        }
      }
    }
  ]
}
=== request textDocument/completion a.nc@4
=== answer
{
  "isIncomplete": false,
  "items": [
    {
      "detail": "= 2 in N20",
      "filterText": "R11",
      "kind": 6,
      "label": "R11",
      "sortText": "10000000011",
      "textEdit": {
        "newText": "R11",
        "range": {
          "end": {
            "character": 7,
            "line": 3
          },
          "start": {
            "character": 5,
            "line": 3
          }
        }
      }
    }
  ]
}
=== request textDocument/completion a.nc@5
=== answer
{
  "isIncomplete": false,
  "items": [
    {
      "detail": "not assigned here",
      "filterText": "R1",
      "kind": 6,
      "label": "R1=",
      "sortText": "10000000001",
      "textEdit": {
        "newText": "R1",
        "range": {
          "end": {
            "character": 7,
            "line": 4
          },
          "start": {
            "character": 4,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "= 2 in N20",
      "filterText": "R11",
      "kind": 6,
      "label": "R11=",
      "sortText": "10000000011",
      "textEdit": {
        "newText": "R11",
        "range": {
          "end": {
            "character": 7,
            "line": 4
          },
          "start": {
            "character": 4,
            "line": 4
          }
        }
      }
    }
  ]
}
=== request textDocument/completion a.nc@6
=== answer
{
  "isIncomplete": false,
  "items": [
    {
      "detail": "next block number",
      "filterText": "N55",
      "kind": 12,
      "label": "N55",
      "sortText": "00000000000",
      "textEdit": {
        "newText": "N55 ",
        "range": {
          "end": {
            "character": 4,
            "line": 5
          },
          "start": {
            "character": 3,
            "line": 5
          }
        }
      }
    }
  ]
}
