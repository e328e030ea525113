#!/usr/bin/env bash
# Runs one of the benchmarks. Usage: tools/commands/bench.sh NAME
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"
# shellcheck source-path=SCRIPTDIR source=../draw/screen.sh
. "$(dirname "$0")/../draw/screen.sh"

names() { find "$LAB_ROOT/benchmarks" -maxdepth 1 -name '*.gd' 2>/dev/null | sed 's:.*/::; s:\.gd$::' | sort | tr '\n' ' '; }

if [ $# -ne 1 ] || [ ! -f "$LAB_ROOT/benchmarks/$1.gd" ]; then
	die 2 "usage: ./lab bench NAME; there are: $(names)"
fi
prepare_project
if grep -q 'opens the window' "$LAB_ROOT/benchmarks/$1.gd"; then
	trap close_screen EXIT
	has_display || open_screen
	use_drivers_beside_godot
	"$godot" --path "$LAB_ROOT" --audio-driver Dummy --rendering-driver opengl3 --resolution 1280x720 \
		-s "benchmarks/$1.gd" </dev/null
	exit
fi
exec "$godot" --headless --path "$LAB_ROOT" -s "benchmarks/$1.gd" </dev/null
