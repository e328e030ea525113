#!/usr/bin/env bash
# Draws lessons into build/pictures/, wide and tall, a line each; fails when a picture is blank or Godot printed an
# error or a warning. Usage: tools/draw/draw.sh GODOT [OPTION...] NAME...   (NAME: a lesson's id, a link to a board such
# as 'dot_product?a=7,1', or start_screen; a picture has the lesson's id as its name)
# Options: --card draws what a lesson's card shows, the board alone and without text; --opening lets a lesson move as it
# does when it is opened; --press=ACTION[*TIMES],... presses keys first, such as --press=lab_next_step*2;
# --size=WIDTHxHEIGHT draws at this size only.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"
# shellcheck source-path=SCRIPTDIR source=screen.sh
. "$(dirname "$0")/screen.sh"

[ $# -ge 2 ] || die 2 "usage: tools/draw/draw.sh GODOT [OPTION...] NAME..."
godot=$1
shift
options=()
size=
while [[ ${1:-} == --* ]]; do
	case $1 in
		--size=*) size=${1#--size=} ;;
		--card | --opening | --press=*) options+=("$1") ;;
		*) die 2 "there is no option '$1'; there are --card, --opening, --press=ACTION[*TIMES],... and --size=WIDTHxHEIGHT" ;;
	esac
	shift
done
pictures=$LAB_BUILD/pictures

# draw NAME FILE SIZE
draw() {
	local picture=$pictures/$2.png log=$pictures/$2.log status=0
	local arguments=("--picture=$picture" "${options[@]}")
	[ "$1" = start_screen ] || arguments+=("--lesson=$1")
	[ -z "$screen" ] || arguments+=(--check-window)
	rm -f "$picture"
	"$LAB_ROOT/tools/shared/run_with_patience.sh" 60 "$godot" --path "$LAB_ROOT" --audio-driver Dummy \
		--rendering-driver opengl3 --resolution "$3" --fixed-fps 60 -s tools/draw/draw_picture.gd -- "${arguments[@]}" \
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
	id=${name%%\?*}
	if [ -n "$size" ]; then
		draw "$name" "${id}_$size" "$size"
	else
		draw "$name" "$id" 1280x720
		draw "$name" "${id}_portrait" 720x1280
	fi
done
exit "$failed"
