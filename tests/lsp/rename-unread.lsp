# A jump whose number cannot be read may lead to the block: its number stays.
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
