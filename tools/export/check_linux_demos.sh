#!/usr/bin/env bash
# Starts each exported Linux demo, lets it draw for half a second, keeps the last picture, and lets it close; a line each.
# Fails when one prints an error or a warning, leaves something behind, or draws nothing. Usage: tools/export/check_linux_demos.sh
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"
# shellcheck source-path=SCRIPTDIR source=../draw/screen.sh
. "$(dirname "$0")/../draw/screen.sh"

exported=$LAB_BUILD/export/linux
kept=$LAB_BUILD/linux_demos
frames=30
# An empty board is smaller as a PNG of 1280x720, every lesson is larger.
least_bytes=30000

# leaks LOG: what was not given back; that is told with --verbose only.
leaks() { grep -E '^Leaked instance|^Orphan |still in use at exit' "$1" || true; }

# check_demo PROGRAM
check_demo() {
	local name status=0 problem
	name=$(basename "$(dirname "$1")")
	local log=$kept/$name.log pictures=$kept/$name picture=$kept/$name.png
	mkdir -p "$pictures"
	"$LAB_ROOT/tools/shared/run_with_patience.sh" 60 "$1" --verbose --audio-driver Dummy --rendering-driver opengl3 \
		--resolution 1280x720 --write-movie "$pictures/frame.png" --fixed-fps 60 --quit-after "$frames" >"$log" || status=$?
	problem=$(messages_of_demo "$log" && leaks "$log")
	[ "$status" -eq 0 ] || problem+=" exit code $status"
	mv "$pictures/frame$(printf %08d $((frames - 1))).png" "$picture" || problem+=" it does not come to frame $frames"
	[ -n "$(find "$picture" -size +"$least_bytes"c)" ] || problem+=" nothing was drawn"
	rm -r "$pictures"
	if [ -z "$problem" ]; then
		echo "started, drawn and closed: $name"
	else
		printf 'FAILED: %s (%s)\n%s\n' "$name" "$log" "$(head -n 20 <<<"$problem" | sed 's/^/  /')"
		failed=1
	fi
}

if [ "$(uname -sm)" != "Linux x86_64" ]; then
	say "the exported Linux demos were not tried: they run on Linux x86_64, not on $(uname -sm)"
	exit
fi
[ -n "$(find "$exported" -name '*.x86_64' 2>/dev/null)" ] || "$LAB_ROOT/lab" export linux

godot=$("$LAB_ROOT/tools/get/get_godot.sh")
rm -rf "$kept"
failed=0
trap close_screen EXIT
has_display || open_screen
use_drivers_beside_godot
for program in "$exported"/*/*.x86_64; do check_demo "$program"; done
exit "$failed"
