#!/usr/bin/env bash
# Looks at lessons in windows of many sizes and prints, for each size, the smallest target and text and what overlaps, is
# cut off, breaks a word or moves while something plays.
# Usage: tools/commands/layout.sh [LESSON...] [--size WIDTHxHEIGHT] [--text 1|1.25|1.5] [--states N]
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

usage="usage: ./lab layout [LESSON...] [--size WIDTHxHEIGHT] [--text 1|1.25|1.5] [--states N]"
options=()
lessons=()
while [ $# -gt 0 ]; do
	case $1 in
	--size) [[ ${2:-} =~ ^[1-9][0-9]{1,4}x[1-9][0-9]{1,4}$ ]] || die 2 "--size must be like 390x844, not '${2:-}'; $usage" ;;
	--text) [[ ${2:-} =~ ^(1|1\.25|1\.5)$ ]] || die 2 "--text must be 1, 1.25 or 1.5, not '${2:-}'; $usage" ;;
	--states) [[ ${2:-} =~ ^[0-9]{1,4}$ ]] || die 2 "--states must be a whole number from 0 to 9999, not '${2:-}'; $usage" ;;
	-*) die 2 "$usage" ;;
	*)
		lessons+=("$1")
		shift
		continue
		;;
	esac
	options+=("$1=$2")
	shift 2
done

prepare_project
known=$(lesson_ids)
for id in ${lessons[@]+"${lessons[@]}"}; do
	grep -qxF -- "$id" <<<"$known" || die 2 "there is no lesson '$id'; there are: ${known//$'\n'/, }"
done
# shellcheck disable=SC2206 # one word for each id
[ ${#lessons[@]} -gt 0 ] || lessons=($known)

# With fixed frames a lesson that moves by itself is the same on every machine.
"$LAB_ROOT/tools/shared/run_with_patience.sh" 900 \
	"$godot" --headless --fixed-fps 60 --path "$LAB_ROOT" -s tools/checks/measure_layout.gd -- \
	${options[@]+"${options[@]}"} "${lessons[@]}"
