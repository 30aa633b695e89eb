# A macrocycle that the project file names keeps its number, and the reason is its key.
=== client
{ "locale": "cs", "capabilities": { "workspace": { "workspaceEdit": { "documentChanges": true, "resourceOperations": ["rename"] } } } }
=== file L8100
N1 G79 L8100
N2 G70
=== file cnc872c.toml
[cycles]
G81 = 8100
[machine-macrocycles]
L9050 = {}
=== open part.nc
%1
N10 G72 L‹mapped›8100
N20 G72 L‹machine›9050
N30 M30
=== request textDocument/rename part.nc@mapped
{ "newName": "8200" }
=== answer
{
  "code": -32803,
  "message": "na makrocyklus L8100 odkazuje klíč cycles.G81 v projektovém souboru"
}
=== request textDocument/rename part.nc@machine
{ "newName": "9051" }
=== answer
{
  "code": -32803,
  "message": "na makrocyklus L9050 odkazuje klíč machine-macrocycles.L9050 v projektovém souboru"
}
