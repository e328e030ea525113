#!/usr/bin/env bash
# Prints what the demo of each lesson holds, read from its exported pack, and how long it takes to show its first frame;
# fails when a pack holds what it does not need, or is too large. Usage: tools/commands/needs.sh [lab|LESSON...]
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"
# shellcheck source-path=SCRIPTDIR source=../draw/screen.sh
. "$(dirname "$0")/../draw/screen.sh"

exported=$LAB_BUILD/export/linux

# is_fresh NAME: nothing in the project is newer than its pack.
is_fresh() {
	local pack=$exported/$1/$1.pck newer
	[ -f "$pack" ] || return 1
	newer=$(find "$LAB_ROOT" -mindepth 1 \( -name .git -o -path "$LAB_ROOT/.godot" -o -path "$LAB_BUILD" \) -prune \
		-o -type f -newer "$pack" -print)
	[ -z "$newer" ]
}

export_stale_ones() {
	local name stale=()
	for name in lab "$@"; do is_fresh "$name" || stale+=("$name"); done
	[ ${#stale[@]} -eq 0 ] || "$LAB_ROOT/tools/commands/export.sh" linux "${stale[@]}" >&2
}

# measure_first_frame NAME: starts the demo, lets it draw one frame and end; prints the milliseconds of all that.
measure_first_frame() {
	local log=$LAB_BUILD/needs/$1.log begun ended said status=0
	begun=$(date +%s%N)
	"$LAB_ROOT/tools/shared/run_with_patience.sh" 30 "$exported/$1/$1.x86_64" --audio-driver Dummy \
		--rendering-driver opengl3 --resolution 1280x720 --quit-after 1 >"$log" || status=$?
	ended=$(date +%s%N)
	said=$(messages_of_demo "$log")
	[ "$status" -eq 0 ] && [ -z "$said" ] ||
		die 1 "the Linux demo '$1' does not start and end cleanly (exit code $status): ${said:-see $log}"
	echo $(((ended - begun) / 1000000))
}

measure_first_frames() {
	local name milliseconds lines=()
	has_display || open_screen
	use_drivers_beside_godot
	for name in "$@"; do
		milliseconds=$(measure_first_frame "$name")
		lines+=("\"$name\": $milliseconds")
	done
	(IFS=,; printf '{%s}\n' "${lines[*]}") >"$exported/first_frames.json"
}

prepare_project
make_build_folder
mkdir -p "$LAB_BUILD/needs"
known=$(demo_ids)
for name in "$@"; do
	grep -qxF -- "$name" <<<"lab"$'\n'"$known" ||
		die 2 "there is no demo '$name'; there are: lab, ${known//$'\n'/, }"
done
# shellcheck disable=SC2086 # one word for each id
[ $# -gt 0 ] || set -- $known
export_stale_ones "$@"
rm -f "$exported/first_frames.json"
trap close_screen EXIT
if [ "$(uname -sm)" = "Linux x86_64" ]; then
	measure_first_frames "$@"
fi

status=0
said=$(run_script export/needs.gd "$@") || status=$?
sed -n 's/^row  //p' <<<"$said"
say "first frame on Linux: from the start of the program to its end after one frame; the files of each pack: build/needs/"
sed -n 's/^broken /lab: /p' <<<"$said" >&2
if [ "$status" -ne 0 ] && ! grep -q '^broken ' <<<"$said"; then printf '%s\n' "$said" >&2; fi
exit "$status"
