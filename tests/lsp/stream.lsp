# The block stream of what is open, with what is not saved.
=== client
{ "locale": "cs" }
=== open part.nc
%1 "díl"
N10 G00 X1
N20 M30
=== request workspace/executeCommand
{ "command": "cnc872c.stream", "arguments": ["DIR/part.nc"] }
=== answer
{
  "text": "{\"kind\":\"program\",\"schema\":\"cnc872c.blocks/2\",\"generator\":\"cnc872c 0.2.0\",\"dialect\":\"cnc872\",\"number\":1,\"title\":\"díl\",\"comments\":[\"díl\"],\"name\":\"part.nc\",\"axes\":[{\"letter\":\"X\",\"kind\":\"linear\"},{\"letter\":\"Y\",\"kind\":\"linear\"},{\"letter\":\"Z\",\"kind\":\"linear\"},{\"letter\":\"A\",\"kind\":\"rotary\"},{\"letter\":\"B\",\"kind\":\"rotary\"},{\"letter\":\"C\",\"kind\":\"rotary\"},{\"letter\":\"U\",\"kind\":\"linear\"},{\"letter\":\"V\",\"kind\":\"linear\"},{\"letter\":\"W\",\"kind\":\"linear\"}],\"g97\":\"per-minute\",\"arc_centers\":\"machine-order\",\"arc_tolerance\":0.01,\"spindle_axis\":\"C\"}\n{\"kind\":\"block\",\"seq\":0,\"n\":10,\"file\":0,\"line\":2,\"column\":1,\"first_block\":true,\"g\":[0,17,98,40,null,53,94,70,80,90,75,34],\"g_set\":[0],\"m\":[null,null,5,40,null,9,53,null,48,null,null,null,null,null,null],\"motion\":{\"type\":\"rapid\",\"axes\":[\"X\"],\"length_missing\":\"start\"},\"position\":{\"X\":1}}\n{\"kind\":\"block\",\"seq\":1,\"n\":20,\"file\":0,\"line\":3,\"column\":1,\"last_block\":true,\"g\":[0,17,98,40,null,53,94,70,80,90,75,34],\"m\":[null,30,5,40,null,9,53,null,48,null,null,null,null,null,null],\"m_set\":[30],\"m_changed\":[1,2,5,6],\"position\":{\"X\":1}}\n{\"kind\":\"end\",\"reason\":\"M30\",\"blocks\":2,\"path_mm\":0}\n",
  "truncated": false
}
=== text part.nc
%1 "díl"
N10 G00 X1,5
N15 Y9,5
N20 M30
=== request workspace/executeCommand
{ "command": "cnc872c.stream", "arguments": ["DIR/part.nc"] }
=== answer
{
  "code": -32803,
  "message": "partprogram nelze přeložit; počet chyb: 2, první: part.nc, řádek 2: desetinná čárka"
}
=== open L9001
N10 G79 L9001
N20 G70
=== request workspace/executeCommand
{ "command": "cnc872c.stream", "arguments": ["DIR/L9001"] }
=== answer
{
  "code": -32803,
  "message": "makrocyklus nemá vlastní proud bloků: zobrazte proud partprogramu, který ho volá"
}
=== request workspace/executeCommand
{ "command": "cnc872c.stream", "arguments": [7] }
=== answer
{
  "code": -32602,
  "message": "očekává se partprogram: URI dokumentu"
}
=== request workspace/executeCommand
{ "command": "rm" }
=== answer
{
  "code": -32602,
  "message": "neznámý příkaz rm"
}
