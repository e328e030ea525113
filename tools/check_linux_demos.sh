#!/usr/bin/env bash
# Starts each exported Linux demo, lets it draw for two seconds and close, a line each; fails when one prints an error or
# a warning, or leaves something behind. Usage: tools/check_linux_demos.sh
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "$0")/common.sh"
# shellcheck source-path=SCRIPTDIR source=screen.sh
. "$(dirname "$0")/screen.sh"

folder=$LAB_BUILD/export/linux
frames=120

# Debian's release template says this of every control in a container that is freed, even in a project with nothing but
# one label in a box; the editor of the same packages and the official builds do not.
known="Attempt to disconnect a nonexistent connection from '.*'. Signal: '(size_flags|visibility)_changed', callable: ''"

messages() {
	if grep -q '^Godot Engine v[^ ]*debian' "$1"; then
		engine_messages "$1" | grep -v -E "$known" || true
	else
		engine_messages "$1"
	fi
}

# leaks LOG: what Godot says of things that were not given back; it does so with --verbose only.
leaks() { grep -E '^(Leaked instance|StringName: |Orphan |Hint: Leaked)|still in use at exit' "$1" || true; }

check_demo() {
	local program=$1 name log status=0 found
	name=$(basename "$(dirname "$program")")
	log=$folder/$name.log
	"$LAB_ROOT/tools/run_with_patience.sh" 60 "$program" --verbose --audio-driver Dummy --rendering-driver opengl3 \
		--resolution 1280x720 --fixed-fps 60 --quit-after "$frames" >"$log" || status=$?
	found=$(messages "$log" && leaks "$log")
	if [ "$status" -eq 0 ] && [ -z "$found" ] && grep -q '^OpenGL API' "$log"; then
		echo "started, drawn for $frames frames and closed: $name"
	else
		echo "FAILED: $name (exit code $status)"
		printf '%s\n' "${found:-$(tail -n 5 "$log")}" | head -n 20 | sed 's/^/  /'
		failed=1
	fi
}

if [ "$(uname -sm)" != "Linux x86_64" ]; then
	say "the exported Linux demos were not tried: they run on Linux x86_64 only, not on $(uname -sm)"
	exit
fi
[ -n "$(find "$folder" -name '*.x86_64' 2>/dev/null)" ] || "$LAB_ROOT/lab" export linux

godot=$("$LAB_ROOT/tools/get_godot.sh")
failed=0
trap close_screen EXIT
has_display || open_screen
use_drivers_beside_godot
for program in "$folder"/*/*.x86_64; do check_demo "$program"; done
exit "$failed"
