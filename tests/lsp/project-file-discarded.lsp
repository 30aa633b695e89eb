# What was typed into a project file with errors, and not saved, holds no longer once that is closed.
=== file cnc872c.toml
[lints]
W0214 = "al
=== open part.nc
%1
N10
N20 M30
=== findings part.nc
1:0-1:3 W0214 block N10 is empty | help: delete it, or say in a comment what it is for
=== open cnc872c.toml
[lints]
W0214 = "allow"
=== text part.nc
%1
N10
N15
N20 M30
=== findings part.nc
=== close cnc872c.toml
=== text part.nc
%1
N10
N15
N20 M30
=== findings part.nc
1:0-1:3 W0214 block N10 is empty | help: delete it, or say in a comment what it is for
2:0-2:3 W0214 block N15 is empty | help: delete it, or say in a comment what it is for
