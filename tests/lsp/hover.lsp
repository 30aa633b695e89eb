# What a word means, and what execution makes of its block.
=== client
{ "locale": "cs-CZ", "capabilities": { "general": { "positionEncodings": ["utf-16", "utf-8"] } } }
=== file cnc872c.toml
dialect = "cnc8x9"
[operations]
"01" = "add"
=== open part.nc
‹0›%14 "VNORENE *SKOKY*"
N10 G54 G17 G90 G94 T7 ‹M06›M06 "ř‹comment›"
N20 ‹S›S2000 M03 M08
N30 G00 X0 Y0 C0
N40 Z5 R10=5 R11=3
‹N50›N50 G71 ‹L10›L10
N60 G91 G00 ‹XR10›X-R10 ‹G73›G73 L50 Q3
N65 G26 ‹R5›R5=01101110
N70 G04 ‹Q50›Q50 Y12.5
N90 G90 G1 X0 Y0 ‹F›F150 G73 L50 ‹Q2›Q2
N100 ‹C›C-90.5
N110 G73 ‹L130›L130
N120 G2 X5
N130 ‹M30›M30
N500 G79 L10 "jeden dulek"
N510 G90 G01 ‹Z›Z-0.8 F120
N520 G00 Z1 G73 L510 Q1
N530 Z5 G70
=== findings part.nc
=== request textDocument/hover part.nc@0
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`%14`** číslo partprogramu\n\n„VNORENE \\*SKOKY\\*“\n\n- osy: X, Y, Z, A, B, C, U, V, W\n- provedené bloky: 112\n- dráha: 419.581 mm\n- konec: `M30`"
  },
  "range": {
    "end": {
      "character": 3,
      "line": 0
    },
    "start": {
      "character": 0,
      "line": 0
    }
  }
}
=== request textDocument/hover part.nc@M06
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`M06`** výměna nástroje\n\nskupina 9 funkcí M; platí jen ve svém bloku\n\n- PLC čte: `ZMM9PI=1` `M06PID=1`\n\n---\n\n**blok N10 se provede 1×**\n\n- poloha po bloku: neznámá\n- platné funkce G: `G00 G17 G98 G40 G54 G94 G80 G90 G75 G34`\n- funkce M po bloku: `M05 M40 M36 M09 M53 M48 M06`\n- technologie: T7"
  },
  "range": {
    "end": {
      "character": 26,
      "line": 1
    },
    "start": {
      "character": 23,
      "line": 1
    }
  }
}
=== request textDocument/hover part.nc@comment
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**blok N10 se provede 1×**\n\n- poloha po bloku: neznámá\n- platné funkce G: `G00 G17 G98 G40 G54 G94 G80 G90 G75 G34`\n- funkce M po bloku: `M05 M40 M36 M09 M53 M48 M06`\n- technologie: T7"
  }
}
=== request textDocument/hover part.nc@S
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`S 2000 ot/min`** otáčky vřetena za minutu\n\nplatí do změny\n\n---\n\n**blok N20 se provede 1×**\n\n- poloha po bloku: neznámá\n- platné funkce G: `G00 G17 G98 G40 G54 G94 G80 G90 G75 G34`\n- funkce M po bloku: `M03 M40 M36 M08 M53 M48`\n- technologie: S 2000 ot/min; T7"
  },
  "range": {
    "end": {
      "character": 9,
      "line": 2
    },
    "start": {
      "character": 4,
      "line": 2
    }
  }
}
=== request textDocument/hover part.nc@N50
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`N50`** číslo bloku\n\n---\n\n**blok N50 se provede 12×**\n\n- poloha po bloku: X 0, -5, -10, -15, … (min -33, max 0) mm; Y 0 mm; Z 5 mm; C 0 °\n- platné funkce G: `G00/G01 G17 G98 G40 G54 G94 G71 G80 G90/G91 G75 G34`\n- funkce M po bloku: `M03 M40 M36 M08 M53 M48`\n- technologie: F 120, 150, ? mm/min; S 2000 ot/min; T7"
  },
  "range": {
    "end": {
      "character": 3,
      "line": 5
    },
    "start": {
      "character": 0,
      "line": 5
    }
  }
}
=== request textDocument/hover part.nc@L10
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`L10`** číslo podprogramu nebo makrocyklu, případně bloku, na který se skáče\n\nvolá podprogram L10\n\n- cíl: `N500 G79 L10`\n\njeden dulek\n\n---\n\n**blok N50 se provede 12×**\n\n- poloha po bloku: X 0, -5, -10, -15, … (min -33, max 0) mm; Y 0 mm; Z 5 mm; C 0 °\n- platné funkce G: `G00/G01 G17 G98 G40 G54 G94 G71 G80 G90/G91 G75 G34`\n- funkce M po bloku: `M03 M40 M36 M08 M53 M48`\n- technologie: F 120, 150, ? mm/min; S 2000 ot/min; T7"
  },
  "range": {
    "end": {
      "character": 11,
      "line": 5
    },
    "start": {
      "character": 8,
      "line": 5
    }
  }
}
=== request textDocument/hover part.nc@XR10
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`X -R10`** 1. osa\n\nlineární osa\n\n---\n\n**blok N60 se provede 12×**\n\n- R10 před blokem (tu hodnotu čtou jeho slova): 5, 8, 11\n- hodnota slova: -5, -8, -11\n- poloha po bloku: X -5, -10, -15, -20, … (min -44, max -5) mm; Y 0 mm; Z 5 mm; C 0 °\n- délka pohybu: 5, 8, 11 mm\n- skok se provede: 9×\n- platné funkce G: `G00 G17 G98 G40 G54 G94 G73 G80 G91 G75 G34`\n- funkce M po bloku: `M03 M40 M36 M08 M53 M48`\n- technologie: F 120 mm/min; S 2000 ot/min; T7"
  },
  "range": {
    "end": {
      "character": 17,
      "line": 6
    },
    "start": {
      "character": 12,
      "line": 6
    }
  }
}
=== request textDocument/hover part.nc@G73
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`G73`** skok na blok téhož programového celku\n\nskupina G7: volání a skoky; platí jen ve svém bloku\n\nskok na blok N50; bloky N50–N60 se provedou 4× za sebou\n\n- cíl: `N50 G71 L10`\n\n---\n\n**blok N60 se provede 12×**\n\n- R10 před blokem (tu hodnotu čtou jeho slova): 5, 8, 11\n- poloha po bloku: X -5, -10, -15, -20, … (min -44, max -5) mm; Y 0 mm; Z 5 mm; C 0 °\n- délka pohybu: 5, 8, 11 mm\n- skok se provede: 9×\n- platné funkce G: `G00 G17 G98 G40 G54 G94 G73 G80 G91 G75 G34`\n- funkce M po bloku: `M03 M40 M36 M08 M53 M48`\n- technologie: F 120 mm/min; S 2000 ot/min; T7"
  },
  "range": {
    "end": {
      "character": 21,
      "line": 6
    },
    "start": {
      "character": 18,
      "line": 6
    }
  }
}
=== request textDocument/hover part.nc@R5
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`R5 = 1101110`** parametr R0–R95\n\nřídicí slovo: `R10 = R10 + R11`; platí do změny\n\n---\n\n**blok N65 se provede 3×**\n\n- R5 po bloku: 1101110\n- R10 po bloku: 8, 11, 14\n- poloha po bloku: X -20, -32, -44 mm; Y 0 mm; Z 5 mm; C 0 °\n- platné funkce G: `G00 G17 G98 G40 G26 G54 G94 G80 G91 G75 G34`\n- funkce M po bloku: `M03 M40 M36 M08 M53 M48`\n- technologie: F 120 mm/min; S 2000 ot/min; T7"
  },
  "range": {
    "end": {
      "character": 19,
      "line": 7
    },
    "start": {
      "character": 8,
      "line": 7
    }
  }
}
=== request textDocument/hover part.nc@Q50
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`Q50`** počet opakování volání nebo skoku; s G04 časová prodleva po 10 ms\n\nčasová prodleva 0.5 s\n\n---\n\n**blok N70 se provede 3×**\n\n- poloha po bloku: X -20, -32, -44 mm; Y 12.5 mm; Z 5 mm; C 0 °\n- délka pohybu: 12.5 mm\n- prodleva: 0.5 s\n- platné funkce G: `G00 G17 G98 G40 G54 G94 G80 G91 G04 G34`\n- funkce M po bloku: `M03 M40 M36 M08 M53 M48`\n- technologie: F 120 mm/min; S 2000 ot/min; T7"
  },
  "range": {
    "end": {
      "character": 11,
      "line": 8
    },
    "start": {
      "character": 8,
      "line": 8
    }
  }
}
=== request textDocument/hover part.nc@F
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`F 150 mm/min`** posuv: při G94 a G96 v mm/min, při G95 v mm/ot; při G97 podle klíče `g97`\n\nplatí do změny\n\n---\n\n**blok N90 se provede 3×**\n\n- poloha po bloku: X 0 mm; Y 0 mm; Z 5 mm; C 0 °\n- délka pohybu: 23.585, 34.355, 45.741 mm\n- skok se provede: 2×\n- platné funkce G: `G01 G17 G98 G40 G54 G94 G73 G80 G90 G75 G34`\n- funkce M po bloku: `M03 M40 M36 M08 M53 M48`\n- technologie: F 150 mm/min; S 2000 ot/min; T7"
  },
  "range": {
    "end": {
      "character": 21,
      "line": 9
    },
    "start": {
      "character": 17,
      "line": 9
    }
  }
}
=== request textDocument/hover part.nc@Q2
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`Q2`** počet opakování volání nebo skoku; s G04 časová prodleva po 10 ms\n\nskok na blok N50; bloky N50–N90 se provedou 3× za sebou\n\n- cíl: `N50 G71 L10`\n\n---\n\n**blok N90 se provede 3×**\n\n- poloha po bloku: X 0 mm; Y 0 mm; Z 5 mm; C 0 °\n- délka pohybu: 23.585, 34.355, 45.741 mm\n- skok se provede: 2×\n- platné funkce G: `G01 G17 G98 G40 G54 G94 G73 G80 G90 G75 G34`\n- funkce M po bloku: `M03 M40 M36 M08 M53 M48`\n- technologie: F 150 mm/min; S 2000 ot/min; T7"
  },
  "range": {
    "end": {
      "character": 32,
      "line": 9
    },
    "start": {
      "character": 30,
      "line": 9
    }
  }
}
=== request textDocument/hover part.nc@C
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`C -90.5 °`** 4. až 6. osa, podle výrobce stroje\n\nrotační osa\n\n---\n\n**blok N100 se provede 1×**\n\n- poloha po bloku: X 0 mm; Y 0 mm; Z 5 mm; C -90.5 °\n- délka pohybu: 90.5 °\n- platné funkce G: `G01 G17 G98 G40 G54 G94 G80 G90 G75 G34`\n- funkce M po bloku: `M03 M40 M36 M08 M53 M48`\n- technologie: F 150 °/min; S 2000 ot/min; T7"
  },
  "range": {
    "end": {
      "character": 11,
      "line": 10
    },
    "start": {
      "character": 5,
      "line": 10
    }
  }
}
=== request textDocument/hover part.nc@L130
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`L130`** číslo podprogramu nebo makrocyklu, případně bloku, na který se skáče\n\nskok na blok N130; provede se vždy\n\n- cíl: `N130 M30`\n\n---\n\n**blok N110 se provede 1×**\n\n- poloha po bloku: X 0 mm; Y 0 mm; Z 5 mm; C -90.5 °\n- skok se provede: 1×\n- platné funkce G: `G01 G17 G98 G40 G54 G94 G73 G80 G90 G75 G34`\n- funkce M po bloku: `M03 M40 M36 M08 M53 M48`\n- technologie: F 150 mm/min; S 2000 ot/min; T7"
  },
  "range": {
    "end": {
      "character": 13,
      "line": 11
    },
    "start": {
      "character": 9,
      "line": 11
    }
  }
}
=== request textDocument/hover part.nc@M30
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`M30`** konec partprogramu\n\nskupina 1 funkcí M; platí jen ve svém bloku\n\n- PLC čte: `ZMM1PI=1` `ZMM2PI=1` `ZMM5PI=1` `ZMM6PI=1` `PB06=05h` `M30_PID=1` `M03PI=0` `M04PI=0` `M19PI=0` `M07PI=0` `M08PI=0` `M50PI=0` `M51PI=0`\n\n---\n\n**blok N130 se provede 1×**\n\n- poloha po bloku: X 0 mm; Y 0 mm; Z 5 mm; C -90.5 °\n- platné funkce G: `G01 G17 G98 G40 G54 G94 G80 G90 G75 G34`\n- funkce M po bloku: `M30 M05 M40 M36 M09 M53 M48`\n- technologie: F 150 mm/min; S 2000 ot/min; T7"
  },
  "range": {
    "end": {
      "character": 8,
      "line": 13
    },
    "start": {
      "character": 5,
      "line": 13
    }
  }
}
=== request textDocument/hover part.nc@Z
=== answer
{
  "contents": {
    "kind": "markdown",
    "value": "**`Z -0.8 mm`** 3. osa\n\nlineární osa\n\n---\n\n**blok N510 se provede 24×**\n\n- poloha po bloku: X 0, -5, -10, -15, … (min -33, max 0) mm; Y 0 mm; Z -0.8 mm; C 0 °\n- délka pohybu: 5.8, 1.8 mm\n- platné funkce G: `G01 G17 G98 G40 G54 G94 G80 G90 G75 G34`\n- funkce M po bloku: `M03 M40 M36 M08 M53 M48`\n- technologie: F 120 mm/min; S 2000 ot/min; T7"
  },
  "range": {
    "end": {
      "character": 18,
      "line": 15
    },
    "start": {
      "character": 13,
      "line": 15
    }
  }
}
