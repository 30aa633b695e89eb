#!/usr/bin/env bash
# Makes plc-tool-change.png: the waveform of the guide's tool change in GTKWave. Needs the built program in CNC872C, and
# from Debian gtkwave, xvfb, imagemagick.
set -euo pipefail
program=$(realpath "${CNC872C:-target/debug/cnc872c}")
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
place=$(mktemp -d)
trap 'kill "$viewer" "$display" 2>/dev/null || true; rm -rf "$place"' EXIT
viewer='' display=''

"$program" plc "$here/../guide/examples/tool-change/tool-change.nc" --compat --format vcd -o "$place/tool-change.vcd"

# The server chooses a free display and writes its number.
Xvfb -displayfd 3 -screen 0 1180x620x24 3>"$place/display" 2>/dev/null &
display=$!
until [ -s "$place/display" ]; do sleep 0.1; done
DISPLAY=:$(cat "$place/display")
export DISPLAY

cd "$place"
touch rc
gtkwave --nomenu --rcfile rc --rcvar 'use_big_fonts on' --rcvar 'initial_window_x 1180' --rcvar 'initial_window_y 620' \
    --rcvar 'splash_disable on' --rcvar 'hide_sst on' --rcvar 'do_initial_zoom_fit yes' \
    tool-change.vcd "$here/plc-tool-change.gtkw" >/dev/null 2>&1 &
viewer=$!
sleep 6
import -window root "$here/plc-tool-change.png"
