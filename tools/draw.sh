#!/usr/bin/env bash
# Draws lessons into build/pictures/, wide and tall, a line each; fails when a picture is blank or Godot printed an
# error or a warning. Usage: tools/draw.sh GODOT NAME...   (NAME: a lesson's id, or start_screen)
# shellcheck disable=SC2329 # close_screen is called by the trap
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "$0")/common.sh"

[ $# -ge 2 ] || die 2 "usage: tools/draw.sh GODOT NAME..."
godot=$1
shift
pictures=$LAB_BUILD/pictures
screen=

# Xvfb takes a free display by itself and says which one.
open_screen() {
	local number
	need Xvfb xvfb libgl1 libgl1-mesa-dri || exit 2
	rm -f "$pictures/display"
	mkfifo "$pictures/display"
	Xvfb -displayfd 3 -screen 0 1280x1280x24 +extension GLX -nolisten tcp 3>"$pictures/display" >"$pictures/xvfb.log" 2>&1 &
	screen=$!
	read -r -t 30 number <"$pictures/display" || die 1 "Xvfb does not start: $(cat "$pictures/xvfb.log")"
	export DISPLAY=:$number
}

close_screen() {
	[ -z "$screen" ] || kill "$screen" 2>/dev/null || true
	rm -f "$pictures/display"
}

# draw NAME FILE SIZE
draw() {
	local picture=$pictures/$2.png log=$pictures/$2.log status=0
	local arguments=("--picture=$picture")
	[ "$1" = start_screen ] || arguments+=("--lesson=$1")
	rm -f "$picture"
	"$LAB_ROOT/tools/run_with_patience.sh" 60 "$godot" --path "$LAB_ROOT" --audio-driver Dummy \
		--rendering-driver opengl3 --resolution "$3" --fixed-fps 60 -s tools/draw_picture.gd -- "${arguments[@]}" \
		>"$log" || status=$?
	if [ "$status" -eq 0 ] && [ -z "$(engine_messages "$log")" ] && grep -q "^$3, " "$log"; then
		echo "drawn: build/pictures/$2.png ($(grep "^$3, " "$log"))"
	else
		echo "FAILED: build/pictures/$2.png ($3 wanted)"
		sed 's/^/  /' "$log"
		failed=1
	fi
}

failed=0
make_build_folder
mkdir -p "$pictures"
trap close_screen EXIT
has_display || open_screen
use_drivers_beside_godot
for name in "$@"; do
	draw "$name" "$name" 1280x720
	draw "$name" "${name}_portrait" 720x1280
done
exit "$failed"
