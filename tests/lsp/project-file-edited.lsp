# While the project file is edited and has errors, programs are judged by its last form without errors; no message pops up.
=== file cnc872c.toml
[lints]
W0214 = "deny"
=== open part.nc
%1
N10
N20 M30
=== findings part.nc
1:0-1:3 W0214 block N10 is empty | help: delete it, or say in a comment what it is for
=== open cnc872c.toml
[lints]
W0214 = "deny"
=== findings cnc872c.toml
=== text cnc872c.toml
[lints]
W0214 = "den
=== findings cnc872c.toml
1:12-1:12 E0701 the configuration cannot be read: a text is not closed by its quote
=== text part.nc
%1
N10
N15
N20 M30
=== findings part.nc
1:0-1:3 W0214 block N10 is empty | help: delete it, or say in a comment what it is for
2:0-2:3 W0214 block N15 is empty | help: delete it, or say in a comment what it is for
