# A longer number would make a line longer than 80 characters: refused (LEX-7).
=== open part.nc
%1
N10 G71 L‹1›5 "eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee"
N20 M30
N30 G79 L5
N40 G70
=== request textDocument/rename part.nc@1
{ "newName": "5000" }
=== answer
{
  "code": -32803,
  "message": "line 2 would get longer than 80 characters"
}
