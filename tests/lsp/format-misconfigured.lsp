# Nothing is formatted while the project file has errors from the beginning: how, it would say.
=== file cnc872c.toml
[format]
codes = "keep"
[limits]
records = "x"
=== open part.nc
%1
N10 G1   X5 F100
N20 M30
=== request textDocument/formatting part.nc
{ "options": { "tabSize": 4, "insertSpaces": true } }
=== answer
null
