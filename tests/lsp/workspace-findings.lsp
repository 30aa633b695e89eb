# Findings in programs of the workspace that are not open: all at first, then what changed.
=== client
{ "locale": "en" }
=== file a.nc
%1
N10 X5,5
N20 M30
=== file b.nc
%2
N10 X1
N20 M30
=== file c.nc
 % 3
N10 X1
=== file note.txt
no program
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
              "character": 8,
              "line": 1
            },
            "start": {
              "character": 4,
              "line": 1
            }
          },
          "severity": 1,
          "source": "cnc872c"
        }
      ],
      "kind": "full",
      "resultId": "1",
      "uri": "DIR/a.nc",
      "version": null
    },
    {
      "items": [
        {
          "code": "E0205",
          "codeDescription": {
            "href": "cnc872c:/explain/en/E0205.md"
          },
          "message": "the program has no end: no block holds M02 or M30\nhelp: end the main program with a block of its own: `N… M30`",
          "range": {
            "end": {
              "character": 3,
              "line": 1
            },
            "start": {
              "character": 0,
              "line": 1
            }
          },
          "severity": 1,
          "source": "cnc872c"
        }
      ],
      "kind": "full",
      "resultId": "3",
      "uri": "DIR/c.nc",
      "version": null
    }
  ]
}
=== open a.nc
%1
N10 X5,5
N20 M30
=== request workspace/diagnostic
{ "previousResultIds": [{ "uri": "DIR/a.nc", "value": "1" }] }
=== answer
{
  "items": [
    {
      "items": [
        {
          "code": "E0205",
          "codeDescription": {
            "href": "cnc872c:/explain/en/E0205.md"
          },
          "message": "the program has no end: no block holds M02 or M30\nhelp: end the main program with a block of its own: `N… M30`",
          "range": {
            "end": {
              "character": 3,
              "line": 1
            },
            "start": {
              "character": 0,
              "line": 1
            }
          },
          "severity": 1,
          "source": "cnc872c"
        }
      ],
      "kind": "full",
      "resultId": "3",
      "uri": "DIR/c.nc",
      "version": null
    },
    {
      "items": [],
      "kind": "full",
      "uri": "DIR/a.nc",
      "version": null
    }
  ]
}
