# The meaning of the word at a place.
=== client
{ "locale": "cs-CZ", "capabilities": { "general": { "positionEncodings": ["utf-16", "utf-8"] } } }
=== open part.nc
%1 "příruba"
N10 "ř" G00 ‹1›X1
N20 M30
=== request textDocument/hover part.nc@1
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "1. osa"
  },
  "range": {
    "end": {
      "character": 15,
      "line": 1
    },
    "start": {
      "character": 13,
      "line": 1
    }
  }
}
