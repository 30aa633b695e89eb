# A macrocycle with findings is opened: what was sent for it is withdrawn, since the client now fetches it. Nothing is shown
# twice, and nothing stays when the fault is fixed.
=== client
{ "capabilities": { "textDocument": { "diagnostic": {} }, "workspace": { "diagnostics": { "refreshSupport": true } } } }
=== file L9001
N1 G79 L9001
N2 X5,5
N3 G70
=== open part.nc
%1
N10 G72 L9001
N30 M30
=== findings L9001
1:3-1:7 E0104 a decimal comma | help: the control knows the decimal point only: write `X5.5`
=== open L9001
N1 G79 L9001
N2 X5,5
N3 G70
=== said textDocument/publishDiagnostics
{
  "diagnostics": [],
  "uri": "DIR/L9001"
}
=== text L9001
N1 G79 L9001
N2 X5.5
N3 G70
=== request textDocument/diagnostic L9001
=== answer
{
  "items": [],
  "kind": "full",
  "resultId": "2"
}
=== close L9001
=== findings L9001
