#!/usr/bin/env bash
# Checks a class's hand-ins: each folder or zip in FOLDER is one. Writes results.csv and results.md, and a line for each
# as it is judged. What has its row already is not judged again. Usage: tools/commands/check.sh FOLDER [--into FOLDER]
# [--again] [--lang en|nl] [--at-least sufficient|good|excellent]   (exit code 1 if one has not reached that)
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

usage="usage: ./lab check FOLDER [--into FOLDER] [--again] [--lang en|nl] [--at-least sufficient|good|excellent]"
[ $# -gt 0 ] && [ -d "$1" ] || die 2 "FOLDER must hold a folder or a zip for each hand-in; $usage"
folder=$(cd -- "$1" && pwd)
into=$folder language=en least=0 again=()
shift
while [ $# -gt 0 ]; do
	case "$1 ${2:-}" in
		"--again "*) again=(--again) && set -- x "$@" ;;
		"--into "?*) into=$2 ;;
		"--lang en" | "--lang nl") language=$2 ;;
		"--at-least sufficient") least=1 ;;
		"--at-least good") least=2 ;;
		"--at-least excellent") least=3 ;;
		*) die 2 "'$1 ${2:-}' is not known; $usage" ;;
	esac
	shift 2
done
mkdir -p -- "$into"
into=$(cd -- "$into" && pwd)

# Everything that is written but for the results is in one folder. One whose process is gone was left by a kill.
homes=${TMPDIR:-/tmp}/vec2_lab_check
for old in "$homes".*; do
	[ ! -d "$old" ] || [ ! -O "$old" ] || kill -0 "${old##*.}" 2>/dev/null || rm -rf -- "$old"
done
home=$homes.$$
mkdir -m 700 "$home"
trap 'rm -rf -- "$home"' EXIT

# The lines for the user: the engine says other things in between.
show() {
	local line
	while IFS= read -r line; do
		[[ $line != '> '* ]] || printf '%s\n' "${line#> }"
	done
}

status=0
prepare_project
unset XDG_DATA_HOME XDG_CONFIG_HOME XDG_CACHE_HOME
HOME=$home "$LAB_ROOT/tools/shared/run_with_patience.sh" 120 \
	"$godot" --headless --path "$LAB_ROOT" -s tools/grading/check_hand_ins.gd -- \
	"$folder" "$into" "$home" "$language" "$least" ${again[@]+"${again[@]}"} | tee "$home/log.txt" | show || status=$?
if grep -q '^SCRIPT ERROR' "$home/log.txt"; then
	grep -A 3 '^SCRIPT ERROR' "$home/log.txt" >&2
	die 3 "the check itself has failed; what is written so far is in $into"
fi
exit "$status"
