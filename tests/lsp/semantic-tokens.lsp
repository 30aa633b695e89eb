# Colours, as a whole and of a range; columns in UTF-16.
=== open part.nc
%1 "díl"
‹1›N10 G00 "ř😀" X1
N20 R1=X‹2›
N30 M30
=== request textDocument/semanticTokens/full part.nc
=== answer
{
  "data": [
    0,
    0,
    2,
    0,
    1,
    0,
    3,
    5,
    13,
    4,
    1,
    0,
    3,
    1,
    1,
    0,
    4,
    3,
    5,
    0,
    0,
    4,
    5,
    13,
    0,
    0,
    6,
    1,
    8,
    0,
    0,
    1,
    1,
    12,
    0,
    1,
    0,
    3,
    1,
    1,
    0,
    4,
    3,
    10,
    2,
    0,
    3,
    1,
    8,
    0,
    1,
    0,
    3,
    1,
    1,
    0,
    4,
    3,
    4,
    0
  ]
}
=== request textDocument/semanticTokens/range part.nc@1..2
=== answer
{
  "data": [
    1,
    0,
    3,
    1,
    1,
    0,
    4,
    3,
    5,
    0,
    0,
    4,
    5,
    13,
    0,
    0,
    6,
    1,
    8,
    0,
    0,
    1,
    1,
    12,
    0,
    1,
    0,
    3,
    1,
    1,
    0,
    4,
    3,
    10,
    2,
    0,
    3,
    1,
    8,
    0
  ]
}
=== open typed.nc
N10
=== request textDocument/semanticTokens/full typed.nc
=== answer
null
