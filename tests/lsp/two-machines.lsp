# Two folders in one window, each with macrocycles of its own: relative paths in settings begin in the folder of the program.
=== client
{ "capabilities": {}, "workspaceFolders": [{ "uri": "DIR/a", "name": "a" }, { "uri": "DIR/b", "name": "b" }],
  "initializationOptions": { "macrocycles": ["macros"] } }
=== file a/macros/L9001
N1 G79 L9001
N2 X1
N3 G70
=== file b/macros/L9001
N1 G79 L9001
N2 X2
N3 G70
=== open b/part.nc
%1
N10 G72 L‹1›9001
N20 M30
=== request textDocument/definition b/part.nc@1
=== answer
[
  {
    "range": {
      "end": {
        "character": 12,
        "line": 0
      },
      "start": {
        "character": 8,
        "line": 0
      }
    },
    "uri": "DIR/b/macros/L9001"
  }
]
