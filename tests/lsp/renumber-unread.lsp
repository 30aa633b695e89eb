# REN-5: what cannot be read cannot be renumbered: the N20 of the jump would be another block.
=== client
{
  "capabilities": {
    "textDocument": {
      "codeAction": {
        "codeActionLiteralSupport": { "codeActionKind": { "valueSet": [] } },
        "disabledSupport": true,
        "dataSupport": true,
        "resolveSupport": { "properties": ["edit"] }
      }
    }
  }
}
=== open part.nc
%1
‹1›N5 X1
N6 X2
N15 GOTOF N20
N20 X3
N30 M30
=== request textDocument/codeAction part.nc@1..1
{ "context": { "diagnostics": [], "only": ["source.renumber"] } }
=== answer
[
  {
    "disabled": {
      "reason": "line 4 cannot be read (E0111)"
    },
    "kind": "source.renumber.cnc872c",
    "title": "renumber the blocks 10 by 10"
  }
]
=== request codeAction/resolve
{ "title": "x", "kind": "source.renumber.cnc872c", "data": { "uri": "DIR/part.nc", "version": 1 } }
=== answer
{
  "code": -32803,
  "message": "line 4 cannot be read (E0111)"
}
