# What can be typed at a place, whole answers.
=== client
{ "locale": "cs-CZ", "capabilities": { "textDocument": { "completion": { "completionItem": { "snippetSupport": true } } } } }
=== file cnc872c.toml
dialect = "cnc8x9"
[machine-constants]
R56 = "00009192"
=== open new.nc
‹1›
=== request textDocument/completion new.nc@1
=== answer
{
  "isIncomplete": true,
  "items": [
    {
      "detail": "nový program",
      "documentation": {
        "kind": "markdown",
        "value": "```nc\n%1 \"název\"\nN10 G90 G54\nN20 T1 M06\nN30 S1000 M03\nN40 G00 X0\nN50 G01 X10 F100\nN60 M05\nN70 M30\n```"
      },
      "filterText": "program",
      "insertTextFormat": 2,
      "kind": 15,
      "label": "program",
      "sortText": "50000000000",
      "textEdit": {
        "newText": "%${1:1} \"${2:název}\"\nN10 G90 G54\nN20 T${3:1} M06\nN30 S${4:1000} M03\nN40 G00 X${5:0}\nN50 G01 X${6:10} F${7:100}$0\nN60 M05\nN70 M30",
        "range": {
          "end": {
            "character": 0,
            "line": 0
          },
          "start": {
            "character": 0,
            "line": 0
          }
        }
      }
    }
  ]
}
=== open part.nc
%1 "příruba"
N10 G00 X0 "ř" M9‹m›
N20 G71 L10‹l›
N30 M03 G9‹g›
N‹n›
N40 M30
N100 G79 L100 "díra"
N110 G70
N120 G79 L1000
N130 G70
=== request textDocument/completion part.nc@m
=== answer
{
  "isIncomplete": false,
  "items": [
    {
      "detail": "vypnutí chlazení 1 a 2",
      "documentation": {
        "kind": "markdown",
        "value": "**M09** – vypnutí chlazení 1 a 2\n\nSkupina 5.\n\nPlatí do další funkce téže skupiny.\n\nPlatí po zapnutí a po M02 a M30."
      },
      "filterText": "M9",
      "kind": 3,
      "label": "M09",
      "sortText": "40000000009",
      "textEdit": {
        "newText": "M09",
        "range": {
          "end": {
            "character": 17,
            "line": 1
          },
          "start": {
            "character": 15,
            "line": 1
          }
        }
      }
    },
    {
      "detail": "funkce stroje, skupina 10",
      "documentation": {
        "kind": "markdown",
        "value": "**M91** – funkce stroje, skupina 10"
      },
      "filterText": "M91",
      "kind": 3,
      "label": "M91",
      "sortText": "40000000091",
      "textEdit": {
        "newText": "M91",
        "range": {
          "end": {
            "character": 17,
            "line": 1
          },
          "start": {
            "character": 15,
            "line": 1
          }
        }
      }
    },
    {
      "detail": "funkce stroje, skupina 10",
      "documentation": {
        "kind": "markdown",
        "value": "**M92** – funkce stroje, skupina 10"
      },
      "filterText": "M92",
      "kind": 3,
      "label": "M92",
      "sortText": "40000000092",
      "textEdit": {
        "newText": "M92",
        "range": {
          "end": {
            "character": 17,
            "line": 1
          },
          "start": {
            "character": 15,
            "line": 1
          }
        }
      }
    }
  ]
}
=== request textDocument/completion part.nc@l
=== answer
{
  "isIncomplete": false,
  "items": [
    {
      "detail": "díra, není volán",
      "filterText": "L100",
      "kind": 3,
      "label": "L100",
      "sortText": "00000000100",
      "textEdit": {
        "newText": "L100",
        "range": {
          "end": {
            "character": 11,
            "line": 2
          },
          "start": {
            "character": 8,
            "line": 2
          }
        }
      }
    },
    {
      "detail": "není volán",
      "filterText": "L1000",
      "kind": 3,
      "label": "L1000",
      "sortText": "00000001000",
      "textEdit": {
        "newText": "L1000",
        "range": {
          "end": {
            "character": 11,
            "line": 2
          },
          "start": {
            "character": 8,
            "line": 2
          }
        }
      }
    }
  ]
}
=== request textDocument/completion part.nc@g
=== answer
{
  "isIncomplete": false,
  "items": [
    {
      "detail": "šroubovice (spirála)",
      "documentation": {
        "kind": "markdown",
        "value": "**G09** – šroubovice (spirála)\n\nSkupina G2: napojování bloků, kopírování, šroubovice.\n\nPlatí do další funkce téže skupiny."
      },
      "filterText": "G9",
      "kind": 3,
      "label": "G09",
      "sortText": "30000000009",
      "textEdit": {
        "newText": "G09",
        "range": {
          "end": {
            "character": 10,
            "line": 3
          },
          "start": {
            "character": 8,
            "line": 3
          }
        }
      }
    },
    {
      "detail": "absolutní souřadnice",
      "documentation": {
        "kind": "markdown",
        "value": "**G90** – absolutní souřadnice\n\nSkupina G9: absolutně nebo přírůstkově.\n\nPlatí do další funkce téže skupiny.\n\nPlatí po zapnutí a po M02 a M30."
      },
      "filterText": "G90",
      "kind": 3,
      "label": "G90",
      "sortText": "30000000090",
      "textEdit": {
        "newText": "G90",
        "range": {
          "end": {
            "character": 10,
            "line": 3
          },
          "start": {
            "character": 8,
            "line": 3
          }
        }
      }
    },
    {
      "detail": "přírůstkové souřadnice",
      "documentation": {
        "kind": "markdown",
        "value": "**G91** – přírůstkové souřadnice\n\nSkupina G9: absolutně nebo přírůstkově.\n\nPlatí do další funkce téže skupiny."
      },
      "filterText": "G91",
      "kind": 3,
      "label": "G91",
      "sortText": "30000000091",
      "textEdit": {
        "newText": "G91",
        "range": {
          "end": {
            "character": 10,
            "line": 3
          },
          "start": {
            "character": 8,
            "line": 3
          }
        }
      }
    },
    {
      "detail": "zápis do tabulky počátků nebo korekcí",
      "documentation": {
        "kind": "markdown",
        "value": "**G92** – zápis do tabulky počátků nebo korekcí\n\nSkupina G10: prodleva, tabulky, průměry.\n\nPlatí jen ve svém bloku.\n\nSlova os v bloku jsou data; nic se nepohybuje."
      },
      "filterText": "G92",
      "kind": 3,
      "label": "G92",
      "sortText": "30000000092",
      "textEdit": {
        "newText": "G92",
        "range": {
          "end": {
            "character": 10,
            "line": 3
          },
          "start": {
            "character": 8,
            "line": 3
          }
        }
      }
    },
    {
      "detail": "zápis počátku tak, aby nástroj stál na programovaných souřadnicích",
      "documentation": {
        "kind": "markdown",
        "value": "**G93** – zápis počátku tak, aby nástroj stál na programovaných souřadnicích\n\nSkupina G10: prodleva, tabulky, průměry.\n\nPlatí jen ve svém bloku.\n\nSlova os v bloku jsou data; nic se nepohybuje."
      },
      "filterText": "G93",
      "kind": 3,
      "label": "G93",
      "sortText": "30000000093",
      "textEdit": {
        "newText": "G93",
        "range": {
          "end": {
            "character": 10,
            "line": 3
          },
          "start": {
            "character": 8,
            "line": 3
          }
        }
      }
    },
    {
      "detail": "posuv za minutu",
      "documentation": {
        "kind": "markdown",
        "value": "**G94** – posuv za minutu\n\nSkupina G6: jednotka posuvu.\n\nPlatí do další funkce téže skupiny.\n\nPlatí po zapnutí a po M02 a M30."
      },
      "filterText": "G94",
      "kind": 3,
      "label": "G94",
      "sortText": "30000000094",
      "textEdit": {
        "newText": "G94",
        "range": {
          "end": {
            "character": 10,
            "line": 3
          },
          "start": {
            "character": 8,
            "line": 3
          }
        }
      }
    },
    {
      "detail": "posuv na otáčku",
      "documentation": {
        "kind": "markdown",
        "value": "**G95** – posuv na otáčku\n\nSkupina G6: jednotka posuvu.\n\nPlatí do další funkce téže skupiny."
      },
      "filterText": "G95",
      "kind": 3,
      "label": "G95",
      "sortText": "30000000095",
      "textEdit": {
        "newText": "G95",
        "range": {
          "end": {
            "character": 10,
            "line": 3
          },
          "start": {
            "character": 8,
            "line": 3
          }
        }
      }
    },
    {
      "detail": "posuv za minutu, konstantní řezná rychlost",
      "documentation": {
        "kind": "markdown",
        "value": "**G96** – posuv za minutu, konstantní řezná rychlost\n\nSkupina G6: jednotka posuvu.\n\nPlatí do další funkce téže skupiny."
      },
      "filterText": "G96",
      "kind": 3,
      "label": "G96",
      "sortText": "30000000096",
      "textEdit": {
        "newText": "G96",
        "range": {
          "end": {
            "character": 10,
            "line": 3
          },
          "start": {
            "character": 8,
            "line": 3
          }
        }
      }
    },
    {
      "detail": "posuv za minutu, nebo na otáčku s konstantní řeznou rychlostí: podle klíče `g97`",
      "documentation": {
        "kind": "markdown",
        "value": "**G97** – posuv za minutu, nebo na otáčku s konstantní řeznou rychlostí: podle klíče `g97`\n\nSkupina G6: jednotka posuvu.\n\nPlatí do další funkce téže skupiny."
      },
      "filterText": "G97",
      "kind": 3,
      "label": "G97",
      "sortText": "30000000097",
      "textEdit": {
        "newText": "G97",
        "range": {
          "end": {
            "character": 10,
            "line": 3
          },
          "start": {
            "character": 8,
            "line": 3
          }
        }
      }
    },
    {
      "detail": "základní stav skupiny: bloky se napojují s rampami",
      "documentation": {
        "kind": "markdown",
        "value": "**G98** – základní stav skupiny: bloky se napojují s rampami\n\nSkupina G2: napojování bloků, kopírování, šroubovice.\n\nPlatí do další funkce téže skupiny.\n\nPlatí po zapnutí a po M02 a M30."
      },
      "filterText": "G98",
      "kind": 3,
      "label": "G98",
      "sortText": "30000000098",
      "textEdit": {
        "newText": "G98",
        "range": {
          "end": {
            "character": 10,
            "line": 3
          },
          "start": {
            "character": 8,
            "line": 3
          }
        }
      }
    }
  ]
}
=== request textDocument/completion part.nc@n
=== answer
{
  "isIncomplete": false,
  "items": [
    {
      "detail": "další číslo bloku",
      "filterText": "N35",
      "kind": 12,
      "label": "N35",
      "sortText": "00000000000",
      "textEdit": {
        "newText": "N35 ",
        "range": {
          "end": {
            "character": 1,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    }
  ]
}
