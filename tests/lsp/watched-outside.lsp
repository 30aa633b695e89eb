# A folder of macrocycles outside of the workspace is watched too.
=== client
{
  "workspaceFolders": [{ "uri": "DIR/ws", "name": "ws" }],
  "capabilities": { "workspace": { "didChangeWatchedFiles": { "dynamicRegistration": true, "relativePatternSupport": true } } }
}
=== file macros/L9001
N10 G79 L9001
N20 G70
=== file ws/cnc872c.toml
macrocycles = ["../macros"]
=== open ws/part.nc
%1
N10 G72 L9001
N20 M30
=== said client/registerCapability
{
  "registrations": [
    {
      "id": "files",
      "method": "workspace/didChangeWatchedFiles",
      "registerOptions": {
        "watchers": [
          {
            "globPattern": "**/cnc872c.toml"
          },
          {
            "globPattern": "**/[lL][0-9]*"
          },
          {
            "globPattern": "**/*.[xX][mM][lL]"
          },
          {
            "globPattern": "**/*.[mM][rR][cC]"
          },
          {
            "globPattern": "**/*.[nN][cC]"
          },
          {
            "globPattern": "**/*.[nN][cC][pP]"
          },
          {
            "globPattern": "**/*.[mM][pP][fF]"
          },
          {
            "globPattern": "**/*.[tT][xX][tT]"
          }
        ]
      }
    }
  ]
}
=== said client/registerCapability
{
  "registrations": [
    {
      "id": "outside-1",
      "method": "workspace/didChangeWatchedFiles",
      "registerOptions": {
        "watchers": [
          {
            "globPattern": {
              "baseUri": "DIR/macros",
              "pattern": "*"
            }
          }
        ]
      }
    }
  ]
}
