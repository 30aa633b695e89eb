# On a lathe X is a diameter (G74), and S a cutting speed under G96 and, here, G97 (MFN-9); words of data move nothing.
=== client
{ "locale": "cs" }
=== file cnc872c.toml
dialect = "cnc8x9"
=== open part.nc
%7
N10 G74 G90 G96 ‹S›S220 M03
N20 G00 X‹X›50 Z2
N30 G97 ‹rev›S180 F0.2
N40 G94 ‹min›S1800 F200
N50 G92 G54 X‹data›5
N60 M30
=== request textDocument/hover part.nc@S
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`S 220`** konstantní řezná rychlost\n\nplatí do změny\n\n---\n\n**blok N10 se provede 1×**\n\n- poloha po bloku: neznámá\n- platné funkce G: `G00 G17 G98 G40 G53 G96 G80 G90 G74 G34`\n- funkce M po bloku: `M03 M40 M36 M09 M53 M48`\n- technologie: S 220 (konstantní řezná rychlost)"
  },
  "range": {
    "end": {
      "character": 20,
      "line": 1
    },
    "start": {
      "character": 16,
      "line": 1
    }
  }
}
=== request textDocument/hover part.nc@X
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`X 50 mm`** 1. osa\n\nlineární osa\n\n---\n\n**blok N20 se provede 1×**\n\n- poloha po bloku: X 25 mm (Ø 50); Z 2 mm\n- délka pohybu: neznámá\n- platné funkce G: `G00 G17 G98 G40 G53 G96 G80 G90 G74 G34`\n- funkce M po bloku: `M03 M40 M36 M09 M53 M48`\n- technologie: S 220 (konstantní řezná rychlost)"
  },
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
=== request textDocument/hover part.nc@rev
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`S 180`** konstantní řezná rychlost\n\nplatí do změny\n\n---\n\n**blok N30 se provede 1×**\n\n- poloha po bloku: X 25 mm (Ø 50); Z 2 mm\n- platné funkce G: `G00 G17 G98 G40 G53 G97 G80 G90 G74 G34`\n- funkce M po bloku: `M03 M40 M36 M09 M53 M48`\n- technologie: F 0.2 mm/ot; S 180 (konstantní řezná rychlost)"
  },
  "range": {
    "end": {
      "character": 12,
      "line": 3
    },
    "start": {
      "character": 8,
      "line": 3
    }
  }
}
=== request textDocument/hover part.nc@min
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`S 1800 ot/min`** otáčky vřetena za minutu\n\nplatí do změny\n\n---\n\n**blok N40 se provede 1×**\n\n- poloha po bloku: X 25 mm (Ø 50); Z 2 mm\n- platné funkce G: `G00 G17 G98 G40 G53 G94 G80 G90 G74 G34`\n- funkce M po bloku: `M03 M40 M36 M09 M53 M48`\n- technologie: F 200 mm/min; S 1800 ot/min"
  },
  "range": {
    "end": {
      "character": 13,
      "line": 4
    },
    "start": {
      "character": 8,
      "line": 4
    }
  }
}
=== request textDocument/hover part.nc@data
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`X 5 mm`** 1. osa\n\nlineární osa\n\n---\n\n**blok N50 se provede 1×**\n\n- poloha po bloku: X 25 mm (Ø 50); Z 2 mm\n- platné funkce G: `G00 G17 G98 G40 G54 G94 G80 G90 G92 G34`\n- funkce M po bloku: `M03 M40 M36 M09 M53 M48`\n- technologie: F 200 mm/min; S 1800 ot/min"
  },
  "range": {
    "end": {
      "character": 14,
      "line": 5
    },
    "start": {
      "character": 12,
      "line": 5
    }
  }
}
