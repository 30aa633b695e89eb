# Where another number could change what the program means, there is none, and a reason.
=== client
{ "locale": "cs", "capabilities": { "textDocument": { "rename": { "prepareSupport": true } } } }
=== file L9001
N1 G79 L9001
N2 G00 XR2
N3 G70
=== file cnc872c.toml
[parameters]
R1 = 5
=== open part.nc
%306
N10 R1=5 R2=2 R3=3 R4=4 R12=1
N20 G00 XR‹configured›1 YR‹shared›2 ZR‹own›3 AR‹before›6
N30 R6=1
N‹n›40 G00 AR‹input›7 CR‹never read›4
N50 G73 L40 Q1
N60 G72 L‹macro›9001
N70 R95=1 G71 L‹sub›100
N80 G73 L99
N90 M30
N100 G79 L100
N110 G73 LR12
N‹by parameter›1 X1
N120 G70
N200 G79 L200
N210 GR3 L‹unclear›100
N220 G70
=== request textDocument/rename part.nc@configured
{ "newName": "20" }
=== answer
{
  "code": -32803,
  "message": "parametru R1 dává hodnotu konfigurace"
}
=== request textDocument/rename part.nc@shared
{ "newName": "20" }
=== answer
{
  "code": -32803,
  "message": "blok N210 může volat makrocyklus, který je znám až za běhu programu a může parametr používat"
}
=== request textDocument/rename part.nc@own
{ "newName": "20" }
=== answer
{
  "code": -32803,
  "message": "blok N210 může volat makrocyklus, který je znám až za běhu programu a může parametr používat"
}
=== request textDocument/rename part.nc@n
{ "newName": "50" }
=== answer
{
  "code": -32803,
  "message": "blok N50 už v tomto souboru je"
}
=== request textDocument/rename part.nc@n
{ "newName": "99" }
=== answer
{
  "code": -32803,
  "message": "G73 L99 teď nikam nevede a pak by vedl sem"
}
=== request textDocument/rename part.nc@n
{ "newName": "10000" }
=== answer
{
  "code": -32803,
  "message": "na blok N40 vedou skoky a G73 dosáhne jen na čísla bloků do 9999"
}
=== request textDocument/rename part.nc@n
{ "newName": "dvacet" }
=== answer
{
  "code": -32803,
  "message": "číslo bloku je celé číslo od 1 do 99999999"
}
=== request textDocument/prepareRename part.nc@macro
=== answer
{
  "code": -32803,
  "message": "soubor makrocyklu L9001 se jmenuje podle jeho čísla a volat ho mohou i programy, které nejsou otevřené"
}
=== request textDocument/prepareRename part.nc@sub
=== answer
{
  "code": -32803,
  "message": "co v bloku N210 označuje L100, je známo až za běhu programu"
}
=== request textDocument/prepareRename part.nc@by parameter
=== answer
{
  "code": -32803,
  "message": "blok N110 bere číslo bloku z R12: může skákat sem"
}
=== request textDocument/rename part.nc@unclear
{ "newName": "20" }
=== answer
{
  "code": -32803,
  "message": "zde není číslo, které by šlo změnit"
}
=== open parameters.nc
%307
N10 R1=5 R3=3 R4=4 R10=1 R11=1
N20 G00 ZR‹own›3 AR‹before›6 BR10
N30 R6=1
N40 G00 CR‹input›7 R9=R11
N50 R‹never read›9=5 R9‹reserved›5=1
N60 M30
=== request textDocument/rename parameters.nc@own
{ "newName": "10" }
=== answer
{
  "code": -32803,
  "message": "R10 se už používá"
}
=== request textDocument/rename parameters.nc@own
{ "newName": "95" }
=== answer
{
  "code": -32803,
  "message": "R95 je vyhrazen pro řídicí funkce"
}
=== request textDocument/rename parameters.nc@own
{ "newName": "96" }
=== answer
{
  "code": -32803,
  "message": "číslo parametru je celé číslo od 0 do 95"
}
=== request textDocument/rename parameters.nc@own
{ "newName": "5" }
=== answer
{
  "changes": {
    "DIR/parameters.nc": [
      {
        "newText": "5",
        "range": {
          "end": {
            "character": 11,
            "line": 1
          },
          "start": {
            "character": 10,
            "line": 1
          }
        }
      },
      {
        "newText": "5",
        "range": {
          "end": {
            "character": 11,
            "line": 2
          },
          "start": {
            "character": 10,
            "line": 2
          }
        }
      }
    ]
  }
}
=== request textDocument/prepareRename parameters.nc@before
=== answer
{
  "code": -32803,
  "message": "R6 se čte dříve, než dostane hodnotu: bere se z tabulky parametrů stroje"
}
=== request textDocument/prepareRename parameters.nc@input
=== answer
{
  "code": -32803,
  "message": "R7 zde nedostává hodnotu: bere se z tabulky parametrů stroje"
}
=== request textDocument/prepareRename parameters.nc@never read
=== answer
{
  "code": -32803,
  "message": "R9 zde nikdo nečte: není známo, k čemu slouží"
}
=== request textDocument/prepareRename parameters.nc@reserved
=== answer
{
  "code": -32803,
  "message": "R95 je vyhrazen pro řídicí funkce"
}
=== open sharing.nc
%308
N10 R2=1 R20=2
N20 G00 XR‹shared›2 YR20
N‹second›20 G72 L9001
N30 G73 L20 Q1
N40 M30
=== request textDocument/prepareRename sharing.nc@shared
=== answer
{
  "code": -32803,
  "message": "R2 používá i makrocyklus L9001, který mohou volat i programy, které nejsou otevřené"
}
=== open errors.nc
%309
N10 R20=1
N20 XR‹with errors›20
N‹second›20 Y1 M3O
N30 G73 L20 Q1
N40 M30
=== request textDocument/prepareRename errors.nc@with errors
=== answer
{
  "code": -32803,
  "message": "program obsahuje chyby: jaké hodnoty mají parametry, není známo"
}
=== request textDocument/rename errors.nc@second
{ "newName": "25" }
=== answer
{
  "changes": {
    "DIR/errors.nc": [
      {
        "newText": "25",
        "range": {
          "end": {
            "character": 3,
            "line": 3
          },
          "start": {
            "character": 1,
            "line": 3
          }
        }
      }
    ]
  }
}
