# shellcheck shell=bash
# A screen in memory for what has to draw where there is no display. Sourced after common.sh.

screen=

# Xvfb takes a free display by itself and says which one.
open_screen() {
	local number folder
	need Xvfb xvfb libgl1 libgl1-mesa-dri || exit 2
	folder=$(mktemp -d)
	mkfifo "$folder/display"
	Xvfb -displayfd 3 -screen 0 1920x1280x24 +extension GLX -nolisten tcp 3>"$folder/display" >"$folder/log" 2>&1 &
	screen=$!
	read -r -t 30 number <"$folder/display" || die 1 "Xvfb does not start: $(cat "$folder/log")"
	export DISPLAY=:$number
	rm -r "$folder"
}

close_screen() { [ -z "$screen" ] || kill "$screen" 2>/dev/null || true; }
