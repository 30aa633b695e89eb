# Completion and hover in the project file.
=== client
{ "locale": "cs" }
=== open cnc872c.toml
dialect = ‹value›
arc‹key›

[limits]
‹limit›

[lints]
empty-‹lint›block = "allow"
=== request textDocument/completion cnc872c.toml@value
=== answer
{
  "isIncomplete": false,
  "items": [
    {
      "detail": "řídicí systém, pro který programy jsou",
      "documentation": {
        "kind": "markdown",
        "value": "# dialect: řídicí systém, pro který programy jsou\n\n- Kde: `cnc872c.toml`, před všemi tabulkami\n- Hodnota: `\"cnc8x6\"`, `\"cnc8x9\"`, `\"cnc872\"`\n- Výchozí: `\"cnc872\"`\n- Na příkazovém řádku: `--dialect`\n- Pravidlo: §12\n\n## Příklad\n\n```toml\ndialect = \"cnc872\"\n```\n"
      },
      "filterText": "\"cnc8x6\"",
      "kind": 12,
      "label": "\"cnc8x6\"",
      "sortText": "0000",
      "textEdit": {
        "newText": "\"cnc8x6\"",
        "range": {
          "end": {
            "character": 10,
            "line": 0
          },
          "start": {
            "character": 10,
            "line": 0
          }
        }
      }
    },
    {
      "detail": "řídicí systém, pro který programy jsou",
      "documentation": {
        "kind": "markdown",
        "value": "# dialect: řídicí systém, pro který programy jsou\n\n- Kde: `cnc872c.toml`, před všemi tabulkami\n- Hodnota: `\"cnc8x6\"`, `\"cnc8x9\"`, `\"cnc872\"`\n- Výchozí: `\"cnc872\"`\n- Na příkazovém řádku: `--dialect`\n- Pravidlo: §12\n\n## Příklad\n\n```toml\ndialect = \"cnc872\"\n```\n"
      },
      "filterText": "\"cnc8x9\"",
      "kind": 12,
      "label": "\"cnc8x9\"",
      "sortText": "0001",
      "textEdit": {
        "newText": "\"cnc8x9\"",
        "range": {
          "end": {
            "character": 10,
            "line": 0
          },
          "start": {
            "character": 10,
            "line": 0
          }
        }
      }
    },
    {
      "detail": "řídicí systém, pro který programy jsou",
      "documentation": {
        "kind": "markdown",
        "value": "# dialect: řídicí systém, pro který programy jsou\n\n- Kde: `cnc872c.toml`, před všemi tabulkami\n- Hodnota: `\"cnc8x6\"`, `\"cnc8x9\"`, `\"cnc872\"`\n- Výchozí: `\"cnc872\"`\n- Na příkazovém řádku: `--dialect`\n- Pravidlo: §12\n\n## Příklad\n\n```toml\ndialect = \"cnc872\"\n```\n"
      },
      "filterText": "\"cnc872\"",
      "kind": 12,
      "label": "\"cnc872\"",
      "sortText": "0002",
      "textEdit": {
        "newText": "\"cnc872\"",
        "range": {
          "end": {
            "character": 10,
            "line": 0
          },
          "start": {
            "character": 10,
            "line": 0
          }
        }
      }
    }
  ]
}
=== request textDocument/completion cnc872c.toml@limit
=== answer
{
  "isIncomplete": false,
  "items": [
    {
      "detail": "nejvyšší počet záznamů bloků ve výstupu",
      "documentation": {
        "kind": "markdown",
        "value": "# limits.records: nejvyšší počet záznamů bloků ve výstupu\n\n- Kde: `cnc872c.toml`, `[limits]`\n- Hodnota: celé číslo 1 nebo větší\n- Výchozí: `10000000`\n- Na příkazovém řádku: `--max-blocks`\n- Pravidlo: FLW-9\n\n## Příklad\n\n```toml\n[limits]\nrecords = 10000000\n```\n"
      },
      "filterText": "records = 10000000",
      "kind": 10,
      "label": "records",
      "sortText": "0000",
      "textEdit": {
        "newText": "records = 10000000",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "nejvyšší počet současně otevřených volání",
      "documentation": {
        "kind": "markdown",
        "value": "# limits.nesting: nejvyšší počet současně otevřených volání\n\n- Kde: `cnc872c.toml`, `[limits]`\n- Hodnota: celé číslo 1–1000\n- Výchozí: `32`\n- Pravidlo: FLW-2\n\n## Příklad\n\n```toml\n[limits]\nnesting = 32\n```\n"
      },
      "filterText": "nesting = 32",
      "kind": 10,
      "label": "nesting",
      "sortText": "0001",
      "textEdit": {
        "newText": "nesting = 32",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "nejvyšší posuv za minutu v mm/min (G94, G96)",
      "documentation": {
        "kind": "markdown",
        "value": "# limits.feed: nejvyšší posuv za minutu v mm/min (G94, G96)\n\n- Kde: `cnc872c.toml`, `[limits]`\n- Hodnota: číslo 1–9999999\n- Výchozí: cnc8x6: `24000`, cnc8x9: `24000`, cnc872: `99999`\n- Pravidlo: TEC-1\n\n## Příklad\n\n```toml\n[limits]\nfeed = 99999\n```\n"
      },
      "filterText": "feed = 99999",
      "kind": 10,
      "label": "feed",
      "sortText": "0002",
      "textEdit": {
        "newText": "feed = 99999",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "nejvyšší otáčky vřetena S v ot/min",
      "documentation": {
        "kind": "markdown",
        "value": "# limits.speed: nejvyšší otáčky vřetena S v ot/min\n\n- Kde: `cnc872c.toml`, `[limits]`\n- Hodnota: celé číslo 1–99999\n- Výchozí: `9999`\n- Pravidlo: §2\n\n## Příklad\n\n```toml\n[limits]\nspeed = 9999\n```\n"
      },
      "filterText": "speed = 9999",
      "kind": 10,
      "label": "speed",
      "sortText": "0003",
      "textEdit": {
        "newText": "speed = 9999",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "o kolik se smí lišit poloměr na začátku a na konci oblouku, v mm; tisícina poloměru tam, kde je to víc",
      "documentation": {
        "kind": "markdown",
        "value": "# limits.arc-tolerance: o kolik se smí lišit poloměr na začátku a na konci oblouku, v mm; tisícina poloměru tam, kde je to víc\n\n- Kde: `cnc872c.toml`, `[limits]`\n- Hodnota: číslo 0–69999.999\n- Výchozí: `0.01`\n- Pravidlo: MOT-4\n\n## Příklad\n\n```toml\n[limits]\narc-tolerance = 0.01\n```\n"
      },
      "filterText": "arc-tolerance = 0.01",
      "kind": 10,
      "label": "arc-tolerance",
      "sortText": "0004",
      "textEdit": {
        "newText": "arc-tolerance = 0.01",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "osy v pořadí stroje; není-li uvedena žádná, existuje všech devět písmen X Y Z A B C U V W; CNC8x6 a CNC8x9 mají nejvýše šest os, šestá je A, B nebo C",
      "documentation": {
        "kind": "markdown",
        "value": "# axes: osy v pořadí stroje; není-li uvedena žádná, existuje všech devět písmen X Y Z A B C U V W; CNC8x6 a CNC8x9 mají nejvýše šest os, šestá je A, B nebo C\n\n- Kde: `cnc872c.toml`, `[[axes]]`\n- `letter`: písmeno osy, každé jednou\n- `kind`: zda osa jezdí (milimetry), nebo se otáčí (stupně)\n- `min`: nejmenší programovaná souřadnice v mm nebo stupních; menší dá varování\n- `max`: největší programovaná souřadnice v mm nebo stupních; větší dá varování\n- Pravidlo: ADR-4\n\n## Příklad\n\n```toml\n[[axes]]\nletter = \"X\"\nkind = \"linear\"\nmin = -10.0\nmax = 650.0\n```\n"
      },
      "filterText": "[[axes]]",
      "kind": 9,
      "label": "[[axes]]",
      "sortText": "0005",
      "textEdit": {
        "newText": "[[axes]]",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "programované polohy před prvním blokem, podle os; X je poloměr tam, kde po zapnutí platí G74",
      "documentation": {
        "kind": "markdown",
        "value": "# start: programované polohy před prvním blokem, podle os; X je poloměr tam, kde po zapnutí platí G74\n\n- Kde: `cnc872c.toml`, `[start]`\n- Klíče: `X`, `Y`, `Z`, `A`, `B`, `C`, `U`, `V`, `W`\n- Hodnoty: číslo -69999.999–69999.999\n- Pravidlo: MOT-2\n\n## Příklad\n\n```toml\n[start]\nX = 0.0\n```\n"
      },
      "filterText": "[start]",
      "kind": 9,
      "label": "[start]",
      "sortText": "0006",
      "textEdit": {
        "newText": "[start]",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "funkce každé skupiny G a M, která platí na začátku programu a po M02 a M30, svým číslem",
      "documentation": {
        "kind": "markdown",
        "value": "# power-up: funkce každé skupiny G a M, která platí na začátku programu a po M02 a M30, svým číslem\n\n- Kde: `cnc872c.toml`, `[power-up]`\n- Pravidlo: GRP-3, MFN-7\n\n## Příklad\n\n```toml\n[power-up]\nG5 = 54\n```\n"
      },
      "filterText": "[power-up]",
      "kind": 9,
      "label": "[power-up]",
      "sortText": "0007",
      "textEdit": {
        "newText": "[power-up]",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "tabulka parametrů stroje na začátku programu",
      "documentation": {
        "kind": "markdown",
        "value": "# parameters: tabulka parametrů stroje na začátku programu\n\n- Kde: `cnc872c.toml`, `[parameters]`\n- Klíče: `R0` až `R95`\n- Na příkazovém řádku: `--param`\n- Pravidlo: PAR-5\n\n## Příklad\n\n```toml\n[parameters]\nR10 = 25.5\n```\n"
      },
      "filterText": "[parameters]",
      "kind": 9,
      "label": "[parameters]",
      "sortText": "0008",
      "textEdit": {
        "newText": "[parameters]",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "operace za každým kódem „oo“ v řídicích slovech funkcí G26 až G29",
      "documentation": {
        "kind": "markdown",
        "value": "# operations: operace za každým kódem „oo“ v řídicích slovech funkcí G26 až G29\n\n- Kde: `cnc872c.toml`, `[operations]`\n- Klíče: `\"00\"` až `\"99\"`\n- Pravidlo: PAR-9\n\n## Příklad\n\n```toml\n[operations]\n\"01\" = \"add\"\n```\n"
      },
      "filterText": "[operations]",
      "kind": 9,
      "label": "[operations]",
      "sortText": "0009",
      "textEdit": {
        "newText": "[operations]",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "makrocyklus, který pevný cyklus volá po každém pohybu, svým číslem",
      "documentation": {
        "kind": "markdown",
        "value": "# cycles: makrocyklus, který pevný cyklus volá po každém pohybu, svým číslem\n\n- Kde: `cnc872c.toml`, `[cycles]`\n- Klíče: `G81` až `G89`\n- Hodnoty: celé číslo 1–9999\n- Pravidlo: GRP-6\n\n## Příklad\n\n```toml\n[cycles]\nG81 = 8100\n```\n"
      },
      "filterText": "[cycles]",
      "kind": 9,
      "label": "[cycles]",
      "sortText": "0010",
      "textEdit": {
        "newText": "[cycles]",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "makrocykly, které má jen stroj; soubor téhož čísla na cestě hledání má přednost",
      "documentation": {
        "kind": "markdown",
        "value": "# machine-macrocycles: makrocykly, které má jen stroj; soubor téhož čísla na cestě hledání má přednost\n\n- Kde: `cnc872c.toml`, `[machine-macrocycles.L9001]`\n- Klíče: `L1` až `L9999`\n- `axes`: osy, kterými smí pohnout, „[]“ žádnou; jejich polohy pak po volání nejsou známy\n- Pravidlo: FLW-12\n\n## Příklad\n\n```toml\n[machine-macrocycles.L9001]\naxes = [\"Z\"]\n```\n"
      },
      "filterText": "[machine-macrocycles.L9001]",
      "kind": 9,
      "label": "[machine-macrocycles.L9001]",
      "sortText": "0011",
      "textEdit": {
        "newText": "[machine-macrocycles.L9001]",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "rozsahy otáček vřetena",
      "documentation": {
        "kind": "markdown",
        "value": "# gears: rozsahy otáček vřetena\n\n- Kde: `cnc872c.toml`, `[[gears]]`\n- `m`: funkce rozsahu, M41 až M44, každá jednou\n- `min`: nejnižší otáčky rozsahu v ot/min\n- `max`: nejvyšší otáčky rozsahu v ot/min, ne pod `min`, ne nad `limits.speed`\n- `output`: část plného napětí při `max`, pro PB11 a PB12\n- Pravidlo: MFN-9\n\n## Příklad\n\n```toml\n[[gears]]\nm = 41\nmin = 20\nmax = 500\noutput = 1\n```\n"
      },
      "filterText": "[[gears]]",
      "kind": 9,
      "label": "[[gears]]",
      "sortText": "0012",
      "textEdit": {
        "newText": "[[gears]]",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "strojní konstanty, jak je ukazuje systém: osm číslic jako text, nebo číslo se třemi desetinnými místy; R56 až R59 určují u CNC8x6 a CNC8x9 M skupiny 10 až 13, každá čtyři funkce po dvou číslicích; jiné udávají totéž co `[motion]`",
      "documentation": {
        "kind": "markdown",
        "value": "# machine-constants: strojní konstanty, jak je ukazuje systém: osm číslic jako text, nebo číslo se třemi desetinnými místy; R56 až R59 určují u CNC8x6 a CNC8x9 M skupiny 10 až 13, každá čtyři funkce po dvou číslicích; jiné udávají totéž co `[motion]`\n\n- Kde: `cnc872c.toml`, `[machine-constants]`\n- Klíče: `R0` až `R999`\n- Pravidlo: MFN-5\n\n## Příklad\n\n```toml\n[machine-constants]\nR340 = 1.0\n```\n"
      },
      "filterText": "[machine-constants]",
      "kind": 9,
      "label": "[machine-constants]",
      "sortText": "0013",
      "textEdit": {
        "newText": "[machine-constants]",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "s čím se počítá pohyb; u CNC8x6 a CNC8x9 udávají tytéž hodnoty strojní konstanty, každou jen jednou",
      "documentation": {
        "kind": "markdown",
        "value": "# motion: s čím se počítá pohyb; u CNC8x6 a CNC8x9 udávají tytéž hodnoty strojní konstanty, každou jen jednou\n\n- Kde: `cnc872c.toml`, `[motion]`\n- `profile`: průběh rychlosti; `\"ramps\"`: bez obálkové rychlosti; `\"linear\"`; `\"parabolic\"`, které potřebuje P v 1. sadě (R338)\n- `recognition`: jak se poznává plynulá návaznost bloků; `\"manual\"`: jen podle G23 a G24; `\"automatic\"`: i podle úhlu (R97)\n- `cycle-ms`: takt interpolace Ts v ms, který příručky systému neuvádějí: bez něj kritérium přesnosti a dynamické kritérium nic neomezují\n- `angle-deg`: toleranční úhel: úhel návaznosti, který není menší, poruší plynulost (R39)\n- `accel-mm-s2`: zrychlení pracovního posuvu mimo plynulou návaznost (R52)\n- `accel-continuous-mm-s2`: zrychlení pracovního posuvu při plynulé návaznosti; 0: `accel-mm-s2` (R236)\n- `accel-rapid-mm-s2`: zrychlení rychloposuvu G00 (R237)\n- `shortest-block-ms`: nejkratší trvání bloku při plynulé návaznosti\n- `break-length-mm`: kratší blok poruší plynulost, i kruhový; 0 nebo záporné: vypnuto (R382)\n- `merge-length-mm`: kratší lineární blok se přidruží k sousednímu; 0 nebo záporné: vypnuto (R383)\n- `accuracy-um`: kritérium přesnosti; 0: vypnuto (R384, dekády 1 až 4)\n- `red-percent`: napojení pod tolika procenty programované rychlosti má červenou tečku; 0: kvůli tomu žádné (R384, R409, dekády 5 až 6)\n- `overload-mm-s2`: dynamické kritérium; 0: vypnuto (R385, dekády 1 až 7)\n- `raise-length-mm`: v kratším bloku rychlost nestoupne nad tu v jeho krajích; jen `\"linear\"`; 0 nebo záporné: vypnuto (R386)\n- `raise-ms`: kritérium času pro nárůst rychlosti; 0 znamená 500 (R395)\n- `look-ahead`: kolik bloků systém předvídá\n- `centripetal-mm-s2`: největší odstředivé zrychlení na kruhu; 0: vypnuto (R411, dekády 1 až 7 v desetinách, je-li 8. dekáda 1)\n- `constant-cutting-rpm`: otáčky vřetena předpokládané při G97, kde S je řezná rychlost\n- `settle-ms`: čekání na konci pohybu, na který se plynule nenavazuje (G23, G24): na dojetí odchylky R06–R07\n- `block-gap-ms`: prodleva před každým blokem při G98\n- `rapid-mm-min`: rychlost G00: jedno číslo po dráze, nebo tabulka podle písmen os, např. `{ X = 12000, Z = 6000 }`; osy v ní neuvedené mají 10000; u rotačních os st/min\n- Pravidlo: CNT, VEL\n\n## Příklad\n\n```toml\n[motion]\nprofile = \"linear\"\nrecognition = \"automatic\"\ncycle-ms = 2\nangle-deg = 60\naccel-mm-s2 = 500\naccel-continuous-mm-s2 = 0\naccel-rapid-mm-s2 = 1000\nshortest-block-ms = 4\nbreak-length-mm = 0\nmerge-length-mm = 0\naccuracy-um = 0\nred-percent = 20\noverload-mm-s2 = 0\nraise-length-mm = 0\nraise-ms = 500\nlook-ahead = 500\ncentripetal-mm-s2 = 0\nconstant-cutting-rpm = 1000\nsettle-ms = 0\nblock-gap-ms = 0\nrapid-mm-min = 10000\n```\n"
      },
      "filterText": "[motion]",
      "kind": 9,
      "label": "[motion]",
      "sortText": "0014",
      "textEdit": {
        "newText": "[motion]",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "sekundy, které trvají funkce; blok trvá podle té nejdelší z nich",
      "documentation": {
        "kind": "markdown",
        "value": "# motion.times: sekundy, které trvají funkce; blok trvá podle té nejdelší z nich\n\n- Kde: `cnc872c.toml`, `[motion.times]`\n- Klíče: `M00` až `M100`, `T`, `S`, `H`, `P`, `D`, `F`\n- Pravidlo: TIM-1\n\n## Příklad\n\n```toml\n[motion.times]\nM06 = 6.5\n```\n"
      },
      "filterText": "[motion.times]",
      "kind": 9,
      "label": "[motion.times]",
      "sortText": "0015",
      "textEdit": {
        "newText": "[motion.times]",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "sady pro dynamické řízení, které platí jen při parabolickém průběhu; sada nebo hodnota, která chybí nebo je 0, je z 1. sady, pak z [motion]",
      "documentation": {
        "kind": "markdown",
        "value": "# motion.sets: sady pro dynamické řízení, které platí jen při parabolickém průběhu; sada nebo hodnota, která chybí nebo je 0, je z 1. sady, pak z [motion]\n\n- Kde: `cnc872c.toml`, `[motion.sets]`\n- Pravidlo: VEL-14\n\n## Příklad\n\n```toml\n[motion.sets]\n```\n"
      },
      "filterText": "[motion.sets]",
      "kind": 9,
      "label": "[motion.sets]",
      "sortText": "0016",
      "textEdit": {
        "newText": "[motion.sets]",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "sada pro G23 I1, platná od začátku (R406 až R411)",
      "documentation": {
        "kind": "markdown",
        "value": "# motion.sets.1: sada pro G23 I1, platná od začátku (R406 až R411)\n\n- Kde: `cnc872c.toml`, `[motion.sets.1]`\n- `parabolic`: parabolické zrychlení P jako číslice konstanty: 50000 tam, kde systém ukazuje 50.000; ryv je P/32.768 mm/s³\n- `linear-mm-s2`: lineární zrychlení A\n- `accuracy-um`: kritérium přesnosti\n- `overload-mm-s2`: dynamické kritérium\n- `centripetal-mm-s2`: největší odstředivé zrychlení na kruhu\n- Pravidlo: VEL-14\n\n## Příklad\n\n```toml\n[motion.sets.1]\nparabolic = 50000\nlinear-mm-s2 = 600\naccuracy-um = 8\noverload-mm-s2 = 10000\ncentripetal-mm-s2 = 400\n```\n"
      },
      "filterText": "[motion.sets.1]",
      "kind": 9,
      "label": "[motion.sets.1]",
      "sortText": "0017",
      "textEdit": {
        "newText": "[motion.sets.1]",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "sada pro G23 I2 (R412 až R417)",
      "documentation": {
        "kind": "markdown",
        "value": "# motion.sets.2: sada pro G23 I2 (R412 až R417)\n\n- Kde: `cnc872c.toml`, `[motion.sets.2]`\n- `parabolic`: parabolické zrychlení P jako číslice konstanty: 50000 tam, kde systém ukazuje 50.000; ryv je P/32.768 mm/s³\n- `linear-mm-s2`: lineární zrychlení A\n- `accuracy-um`: kritérium přesnosti\n- `overload-mm-s2`: dynamické kritérium\n- `centripetal-mm-s2`: největší odstředivé zrychlení na kruhu\n- Pravidlo: VEL-14\n\n## Příklad\n\n```toml\n[motion.sets.2]\nparabolic = 50000\nlinear-mm-s2 = 600\naccuracy-um = 8\noverload-mm-s2 = 10000\ncentripetal-mm-s2 = 400\n```\n"
      },
      "filterText": "[motion.sets.2]",
      "kind": 9,
      "label": "[motion.sets.2]",
      "sortText": "0018",
      "textEdit": {
        "newText": "[motion.sets.2]",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "sada pro G23 I3 (R418 až R423)",
      "documentation": {
        "kind": "markdown",
        "value": "# motion.sets.3: sada pro G23 I3 (R418 až R423)\n\n- Kde: `cnc872c.toml`, `[motion.sets.3]`\n- `parabolic`: parabolické zrychlení P jako číslice konstanty: 50000 tam, kde systém ukazuje 50.000; ryv je P/32.768 mm/s³\n- `linear-mm-s2`: lineární zrychlení A\n- `accuracy-um`: kritérium přesnosti\n- `overload-mm-s2`: dynamické kritérium\n- `centripetal-mm-s2`: největší odstředivé zrychlení na kruhu\n- Pravidlo: VEL-14\n\n## Příklad\n\n```toml\n[motion.sets.3]\nparabolic = 50000\nlinear-mm-s2 = 600\naccuracy-um = 8\noverload-mm-s2 = 10000\ncentripetal-mm-s2 = 400\n```\n"
      },
      "filterText": "[motion.sets.3]",
      "kind": 9,
      "label": "[motion.sets.3]",
      "sortText": "0019",
      "textEdit": {
        "newText": "[motion.sets.3]",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "sada pro G23 I4 (R424 až R429)",
      "documentation": {
        "kind": "markdown",
        "value": "# motion.sets.4: sada pro G23 I4 (R424 až R429)\n\n- Kde: `cnc872c.toml`, `[motion.sets.4]`\n- `parabolic`: parabolické zrychlení P jako číslice konstanty: 50000 tam, kde systém ukazuje 50.000; ryv je P/32.768 mm/s³\n- `linear-mm-s2`: lineární zrychlení A\n- `accuracy-um`: kritérium přesnosti\n- `overload-mm-s2`: dynamické kritérium\n- `centripetal-mm-s2`: největší odstředivé zrychlení na kruhu\n- Pravidlo: VEL-14\n\n## Příklad\n\n```toml\n[motion.sets.4]\nparabolic = 50000\nlinear-mm-s2 = 600\naccuracy-um = 8\noverload-mm-s2 = 10000\ncentripetal-mm-s2 = 400\n```\n"
      },
      "filterText": "[motion.sets.4]",
      "kind": 9,
      "label": "[motion.sets.4]",
      "sortText": "0020",
      "textEdit": {
        "newText": "[motion.sets.4]",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "sada pro G00 (R430 až R432)",
      "documentation": {
        "kind": "markdown",
        "value": "# motion.sets.rapid: sada pro G00 (R430 až R432)\n\n- Kde: `cnc872c.toml`, `[motion.sets.rapid]`\n- `parabolic`: parabolické zrychlení P jako číslice konstanty: 50000 tam, kde systém ukazuje 50.000; ryv je P/32.768 mm/s³\n- `linear-mm-s2`: lineární zrychlení A\n- Pravidlo: VEL-8\n\n## Příklad\n\n```toml\n[motion.sets.rapid]\nparabolic = 50000\nlinear-mm-s2 = 600\n```\n"
      },
      "filterText": "[motion.sets.rapid]",
      "kind": 9,
      "label": "[motion.sets.rapid]",
      "sortText": "0021",
      "textEdit": {
        "newText": "[motion.sets.rapid]",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "poloměrové korekce podle čísla D, jak jsou v tabulce systému; pro obraz korigované dráhy",
      "documentation": {
        "kind": "markdown",
        "value": "# corrections: poloměrové korekce podle čísla D, jak jsou v tabulce systému; pro obraz korigované dráhy\n\n- Kde: `cnc872c.toml`, `[corrections.7]`\n- Klíče: `1` až `99`\n- `radius`: poloměr nástroje v mm\n- Pravidlo: EQU-1\n\n## Příklad\n\n```toml\n[corrections.7]\nradius = 5.0\n```\n"
      },
      "filterText": "[corrections.7]",
      "kind": 9,
      "label": "[corrections.7]",
      "sortText": "0022",
      "textEdit": {
        "newText": "[corrections.7]",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "jak `format` upravuje zápis programů",
      "documentation": {
        "kind": "markdown",
        "value": "# format: jak `format` upravuje zápis programů\n\n- Kde: `cnc872c.toml`, `[format]`\n- `codes`: jak se píšou čísla G a M: `G01`, `G1`, nebo beze změny\n- `numbers`: jak se píšou souřadnice, F a hodnoty R: beze změny, nebo bez zbytečných nul (z `X036.120` je `X36.12`)\n- `indent`: mezery před řádkem, na kterém blok pokračuje\n- `blank-lines`: nejvyšší počet prázdných řádků za sebou\n- Pravidlo: FMT-5\n\n## Příklad\n\n```toml\n[format]\ncodes = \"two-digits\"\nnumbers = \"keep\"\nindent = 2\nblank-lines = 1\n```\n"
      },
      "filterText": "[format]",
      "kind": 9,
      "label": "[format]",
      "sortText": "0023",
      "textEdit": {
        "newText": "[format]",
        "range": {
          "end": {
            "character": 0,
            "line": 4
          },
          "start": {
            "character": 0,
            "line": 4
          }
        }
      }
    },
    {
      "detail": "jak `restart` najíždí na místo v programu",
      "documentation": {
        "kind": "markdown",
        "value": "# restart: jak `restart` najíždí na místo v programu\n\n- Kde: `cnc872c.toml`, `[restart]`\n- `tool-axis`: osa, po které nástroj opouští obrobek; nahoru vedou větší hodnoty\n- Pravidlo: RST-2\n\n## Příklad\n\n```toml\n[restart]\ntool-axis = \"Z\"\n```\n"
      },
      "filterText": "[restart]",
      "kind": 9,
      "label": "[restart]",
      "sortText": "0024",
      "textEdit": {
        "newText": "[restart]",
        "range": {
          "end": {
            "character": 0,
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
=== request textDocument/hover cnc872c.toml@value
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "# dialect: řídicí systém, pro který programy jsou\n\n- Kde: `cnc872c.toml`, před všemi tabulkami\n- Hodnota: `\"cnc8x6\"`, `\"cnc8x9\"`, `\"cnc872\"`\n- Výchozí: `\"cnc872\"`\n- Na příkazovém řádku: `--dialect`\n- Pravidlo: §12\n\n## Příklad\n\n```toml\ndialect = \"cnc872\"\n```\n"
  },
  "range": {
    "end": {
      "character": 10,
      "line": 0
    },
    "start": {
      "character": 0,
      "line": 0
    }
  }
}
=== request textDocument/hover cnc872c.toml@lint
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "# W0214: empty-block\n\nBlok obsahuje jen své číslo.\n\n## Příklad\n\n```nc expect=W0214\n%1\nN10 G0 X0 Y0\nN20\nN30 M30\n```\n\n## Proč\n\nTakový blok je dovolen: systém ho uloží a nic v něm neudělá. Většinou ale z bloku něco vypadlo,\ntřeba pohyb nebo roztočení vřetena, a stroj pojede dál bez toho.\n\nBlok s komentářem nebo s `/` varování nedá, takže k bloku, který slouží jen jako cíl skoku, je\ndobré připsat komentář. Komentář na vlastním řádku patří k bloku pod ním, ne k bloku nad ním.\n\n## Jak to napsat\n\nDoplnit chybějící slova nebo komentář, k čemu blok je; jinak blok smazat.\n\n```nc ok\n%1\nN10 G0 X0 Y0\nN20 \"místo pro měření sondou\"\nN30 M30\n```\n\nPravidlo: BLK-5\n"
  },
  "range": {
    "end": {
      "character": 21,
      "line": 7
    },
    "start": {
      "character": 0,
      "line": 7
    }
  }
}
=== request textDocument/hover cnc872c.toml@key
=== answer
null
