# A jump whose number cannot be read may lead to the block, and a word that cannot be read may use the parameter: their numbers stay.
=== client
{ "locale": "en", "capabilities": { "textDocument": { "rename": { "prepareSupport": true } } } }
=== open part.nc
%1
N‹n›10 G54
N20 X1
N30 G73 L10 Q1
N36 G73 L1O
N38 G71 L‹sub›100
N40 M30
N50 G79 L100
N‹inside›60 G70
=== request textDocument/rename part.nc@n
{ "newName": "15" }
=== answer
{
  "code": -32803,
  "message": "the number behind L in block N36 cannot be read: it may be this one"
}
=== request textDocument/rename part.nc@sub
{ "newName": "200" }
=== answer
{
  "changes": {
    "DIR/part.nc": [
      {
        "newText": "200",
        "range": {
          "end": {
            "character": 12,
            "line": 5
          },
          "start": {
            "character": 9,
            "line": 5
          }
        }
      },
      {
        "newText": "200",
        "range": {
          "end": {
            "character": 12,
            "line": 7
          },
          "start": {
            "character": 9,
            "line": 7
          }
        }
      }
    ]
  }
}
=== request textDocument/rename part.nc@inside
{ "newName": "65" }
=== answer
{
  "changes": {
    "DIR/part.nc": [
      {
        "newText": "65",
        "range": {
          "end": {
            "character": 3,
            "line": 8
          },
          "start": {
            "character": 1,
            "line": 8
          }
        }
      }
    ]
  }
}
=== open parameters.nc
%2
N10 R10=5 R1=2
N20 XR‹ten›10 YR‹one›1
N30 X-R10/2
N40 M30
=== request textDocument/prepareRename parameters.nc@ten
=== answer
{
  "code": -32803,
  "message": "line 4 has R10 in a place that cannot be read: fix that first"
}
=== request textDocument/prepareRename parameters.nc@one
=== answer
{
  "placeholder": "1",
  "range": {
    "end": {
      "character": 12,
      "line": 2
    },
    "start": {
      "character": 11,
      "line": 2
    }
  }
}
=== open behind.nc
%3
N40 G71 L‹behind›200
N90 M30
N100 G79 L100
*110 X5
N120 G70
N200 G79 L200
N210 G70
=== request textDocument/prepareRename behind.nc@behind
=== answer
{
  "code": -32803,
  "message": "line 7 has 200 in a place that cannot be read: fix that first"
}
=== open lines.nc
%4
N‹split›60 X5
N65 G73 L
60 Q2
N70 M30
N100 G79 L‹called›100
N110 CALL L100
N120 G70
=== request textDocument/prepareRename lines.nc@split
=== answer
{
  "code": -32803,
  "message": "the number behind L in block N65 cannot be read: it may be this one"
}
=== request textDocument/prepareRename lines.nc@called
=== answer
{
  "code": -32803,
  "message": "line 7 has 100 in a place that cannot be read: fix that first"
}
=== open pieces.nc
%5
N‹apart›60 7G1 X5 F100
N65 X1
N70 M30
=== request textDocument/rename pieces.nc@apart
{ "newName": "100" }
=== answer
{
  "changes": {
    "DIR/pieces.nc": [
      {
        "newText": "100",
        "range": {
          "end": {
            "character": 3,
            "line": 1
          },
          "start": {
            "character": 1,
            "line": 1
          }
        }
      }
    ]
  }
}
