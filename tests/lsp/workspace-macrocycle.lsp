# A fault in a macrocycle that only a closed program calls stands in the list too, once for two callers; when a program is
# opened that leads there, the document's own findings have it.
=== file shared/L9001
N1 G79 L9001
N2 G00 X5,5
N3 G70
=== file cnc872c.toml
macrocycles = ["shared"]
=== file a.nc
%1
N10 G72 L9001
N20 M30
=== file b.nc
%2
N10 G72 L9001
N20 M30
=== request workspace/diagnostic
{ "previousResultIds": [] }
=== answer
{
  "items": [
    {
      "items": [
        {
          "code": "E0104",
          "codeDescription": {
            "href": "cnc872c:/explain/en/E0104.md"
          },
          "message": "a decimal comma\nhelp: the control knows the decimal point only: write `X5.5`",
          "range": {
            "end": {
              "character": 11,
              "line": 1
            },
            "start": {
              "character": 7,
              "line": 1
            }
          },
          "severity": 1,
          "source": "cnc872c"
        }
      ],
      "kind": "full",
      "resultId": "5d3221843bc643c7",
      "uri": "DIR/shared/L9001",
      "version": null
    }
  ]
}
=== open a.nc
%1
N10 G72 L9001
N20 M30
=== findings shared/L9001
1:7-1:11 E0104 a decimal comma | help: the control knows the decimal point only: write `X5.5`
=== request workspace/diagnostic
{ "previousResultIds": [] }
=== answer
{
  "items": []
}
