# A fault in a macrocycle that only a closed program calls stands in the list too, once for two callers; when a program is
# opened that leads there, the document's own findings have it.
=== file shared/L9001
N1 G79 L9001
N2 G00 X5,5
N3 G70
=== file cnc872c.toml
macrocycles = ["shared"]
=== file a.nc
%1
N10 G72 L9001
N20 M30
=== file b.nc
%2
N10 G72 L9001
N20 M30
=== request workspace/diagnostic
{ "previousResultIds": [] }
=== answer
=== open a.nc
%1
N10 G72 L9001
N20 M30
=== findings shared/L9001
=== request workspace/diagnostic
{ "previousResultIds": [] }
=== answer
