#!/usr/bin/env bash
# Does in the real editor what a student does: opens a fresh copy of the project, opens my_vec2.gd by its name, types a
# wrong body of `dot` and a right one with the keys of a keyboard, and saves. The lab runs beside it and must say so both
# times. Fails also when the editor prints an error or a warning, and when a process is left after the lab was killed.
# Usage: tools/editor/check_workshop.sh
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"
# shellcheck source-path=SCRIPTDIR source=../draw/screen.sh
. "$(dirname "$0")/../draw/screen.sh"
# shellcheck source-path=SCRIPTDIR source=editor.sh
. "$(dirname "$0")/editor.sh"

# Seconds for the editor to read a fresh project; for the lab to say what it must; for a process to end.
SECONDS_TO_OPEN=240
SECONDS_TO_SAY=20
SECONDS_TO_END=10
WRONG='return x * other.x - y * other.y'
RIGHT='return x * other.x + y * other.y'
log=$LAB_BUILD/workshop_editor.log
lab_log=$LAB_BUILD/workshop_lab.log
editor=
lab=

clean_up() {
	local process
	for process in $lab $editor; do
		kill "$process" 2>/dev/null || true
	done
	close_screen
}

fail() {
	echo "FAILED: $*"
	echo "the editor's log is $log, the lab's $lab_log:"
	tail -n 5 "$log" "$lab_log"
	exit 1
}

# within SECONDS COMMAND...: waits until it is true.
within() {
	local end=$((SECONDS + $1))
	shift
	until "$@"; do
		[ "$SECONDS" -lt "$end" ] || return 1
		sleep 0.05
	done
}

start() {
	"${at_home[@]}" "$godot" --path "$copy" --audio-driver Dummy --rendering-driver opengl3 "$@" </dev/null &
	started=$!
}

# The editor's window names the scene that is open, as soon as the project has been read.
find_window() {
	window=$(xdotool search --onlyvisible --name 'tscn - Vec2 Lab - Godot Engine' 2>/dev/null | head -n 1)
	[ -n "$window" ] || is_gone "$editor"
}

# Without a window manager nobody else gives it the keyboard.
take_keyboard() {
	xdotool windowfocus --sync "$window"
	sleep 1
}

press() { xdotool key --delay 60 "$@"; }
type_keys() { xdotool type --delay 40 "$1"; }

# By its name in the editor's list of files.
open_file() {
	take_keyboard
	press ctrl+alt+o
	sleep 1
	type_keys "$1"
	sleep 1
	press Return
	sleep 1
	take_keyboard
}

go_to_line() {
	press ctrl+Home
	xdotool key --delay 20 --repeat $(($1 - 1)) Down
}

is_typed() { sed -n "${line}p" "$copy/workshop/my_vec2.gd" | grep -qxF -- $'\t'"$1"; }
has_said() { grep -qE -- "$1" "$lab_log"; }

# type_body CODE SAID: over the body of `dot`; the lab must say so then.
type_body() {
	local saved said
	press End shift+Home
	type_keys "$1"
	press ctrl+s
	within "$SECONDS_TO_SAY" is_typed "$1" || fail "'$1' is not in line $line of my_vec2.gd: $(sed -n "${line}p" "$copy/workshop/my_vec2.gd")"
	# Milliseconds of the day, in the log and here.
	saved=$(($(date -r "$copy/workshop/my_vec2.gd" +%s%3N) % 86400000))
	within "$SECONDS_TO_SAY" has_said "$2" || fail "the lab does not say '$2'"
	said=$(grep -E -- "$2" "$lab_log" | head -n 1)
	echo "ok: typed and saved '$1'; $(($(cut -d ' ' -f 2 <<<"$said") - saved)) ms later the lab says: $(cut -d ' ' -f 3- <<<"$said")"
}

# One that has ended may wait for somebody who asks how.
is_gone() { [[ $(ps -o stat= -p "$1") =~ ^(Z.*)?$ ]]; }

need git git || exit 2
need xdotool xdotool || exit 2
prepare_project
make_build_folder
trap clean_up EXIT
open_screen
use_drivers_beside_godot
export LC_ALL=C.UTF-8
make_copy

begun=$SECONDS
start --editor >"$log" 2>&1
editor=$started
within "$SECONDS_TO_OPEN" find_window || fail "the editor does not open"
! is_gone "$editor" || fail "the editor has ended"
echo "ok: the editor has read the fresh project after $((SECONDS - begun)) s"
xdotool windowmove "$window" 0 0 windowsize "$window" 1920 1080
start --resolution 1280x720 -s tools/editor/told_by_lab.gd -- --lesson=dot_product >"$lab_log" 2>&1
lab=$started
within "$SECONDS_TO_SAY" has_said 'Write dot in my_vec2.gd' || fail "the lab does not open the lesson"

line=$(($(grep -n '^func dot(' "$copy/workshop/my_vec2.gd" | cut -d : -f 1) + 1))
open_file my_vec2
go_to_line "$line"
type_body "$WRONG" '✗ .*The two products are subtracted: add them\. \| yours: a·b = 62$'
type_body "$RIGHT" 'Exercise 4: .* \| yours: a·b = 50$'
difference=$(diff "$copy/workshop/starters/my_vec2.gd" "$copy/workshop/my_vec2.gd" | tail -n +2) || true
[ "$difference" = $'< \treturn 0.0\n---\n> \t'"$RIGHT" ] || fail "more than the body was changed: $difference"

children=$(pgrep -P "$lab") || fail "the lab has no child, so nobody has judged"
[ "$(ps -o comm= -p "$lab")" = "$(basename "$godot")" ] || fail "process $lab is not the lab"
kill -9 "$lab"
wait "$lab" 2>/dev/null || true
for process in $lab $children; do
	within "$SECONDS_TO_END" is_gone "$process" || fail "process $process is left"
done
echo "ok: the lab was killed, and nothing of it is left"

take_keyboard
press ctrl+q
within "$SECONDS_TO_END" is_gone "$editor" || fail "the editor does not end"
said=$(said_by_editor "$log")$(engine_messages "$lab_log")
[ -z "$said" ] || fail "$said"
echo "ok: neither the editor nor the lab has an error or a warning"
