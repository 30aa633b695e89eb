# Programs and macrocycles of the workspace, the units of open documents.
=== file a/flange.nc
%1200 "PŘÍRUBA 120 x 80"
N10 M30
=== file a/b/L9001
"--- L9001: vrtani ---"
N1 G79 L9001
N2 G70
=== file a/b/l12.NC
N1 G79 L12 "pocket"
N2 G70
=== file a/notes.txt
50 % of the tools
=== file a/program.txt
%5
N1 M30
=== file .git/x.nc
%1 "hidden"
=== file target/y.nc
%2 "built"
=== open a/open.nc
%77 "open"
N1 G71 L100
N2 M30
N10 G79 L100 "příruba: jedna vrstva"
N20 G70
=== findings a/open.nc
=== request workspace/symbol
{ "query": "" }
=== answer
[
  {
    "containerName": "open.nc",
    "kind": 2,
    "location": {
      "range": {
        "end": {
          "character": 3,
          "line": 0
        },
        "start": {
          "character": 0,
          "line": 0
        }
      },
      "uri": "DIR/a/open.nc"
    },
    "name": "%77 open"
  },
  {
    "containerName": "open.nc",
    "kind": 12,
    "location": {
      "range": {
        "end": {
          "character": 12,
          "line": 3
        },
        "start": {
          "character": 0,
          "line": 3
        }
      },
      "uri": "DIR/a/open.nc"
    },
    "name": "L100 příruba: jedna vrstva"
  },
  {
    "containerName": "flange.nc",
    "kind": 2,
    "location": {
      "range": {
        "end": {
          "character": 5,
          "line": 0
        },
        "start": {
          "character": 0,
          "line": 0
        }
      },
      "uri": "DIR/a/flange.nc"
    },
    "name": "%1200 PŘÍRUBA 120 x 80"
  },
  {
    "containerName": "program.txt",
    "kind": 2,
    "location": {
      "range": {
        "end": {
          "character": 2,
          "line": 0
        },
        "start": {
          "character": 0,
          "line": 0
        }
      },
      "uri": "DIR/a/program.txt"
    },
    "name": "%5"
  },
  {
    "containerName": "L9001",
    "kind": 12,
    "location": {
      "range": {
        "end": {
          "character": 12,
          "line": 1
        },
        "start": {
          "character": 0,
          "line": 1
        }
      },
      "uri": "DIR/a/b/L9001"
    },
    "name": "L9001 vrtani"
  },
  {
    "containerName": "l12.NC",
    "kind": 12,
    "location": {
      "range": {
        "end": {
          "character": 10,
          "line": 0
        },
        "start": {
          "character": 0,
          "line": 0
        }
      },
      "uri": "DIR/a/b/l12.NC"
    },
    "name": "L12 pocket"
  }
]
=== request workspace/symbol
{ "query": "PŘÍRUBA" }
=== answer
[
  {
    "containerName": "open.nc",
    "kind": 12,
    "location": {
      "range": {
        "end": {
          "character": 12,
          "line": 3
        },
        "start": {
          "character": 0,
          "line": 3
        }
      },
      "uri": "DIR/a/open.nc"
    },
    "name": "L100 příruba: jedna vrstva"
  },
  {
    "containerName": "flange.nc",
    "kind": 2,
    "location": {
      "range": {
        "end": {
          "character": 5,
          "line": 0
        },
        "start": {
          "character": 0,
          "line": 0
        }
      },
      "uri": "DIR/a/flange.nc"
    },
    "name": "%1200 PŘÍRUBA 120 x 80"
  }
]
=== request workspace/symbol
{ "query": "l9vr" }
=== answer
[
  {
    "containerName": "L9001",
    "kind": 12,
    "location": {
      "range": {
        "end": {
          "character": 12,
          "line": 1
        },
        "start": {
          "character": 0,
          "line": 1
        }
      },
      "uri": "DIR/a/b/L9001"
    },
    "name": "L9001 vrtani"
  }
]
