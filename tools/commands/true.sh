#!/usr/bin/env bash
# Shows lessons in many states, at each of their steps, and prints what they say that is false, once a kind.
# Usage: tools/commands/true.sh [LESSON...] [--states N] [--seed S]
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

usage="usage: ./lab true [LESSON...] [--states N] [--seed S]"
options=()
lessons=()
while [ $# -gt 0 ]; do
	case $1 in
	--states | --seed)
		[[ ${2:-} =~ ^[1-9][0-9]{0,5}$ ]] || die 2 "$1 must be a whole number from 1 to 999999, not '${2:-}'; $usage"
		options+=("$1=$2")
		shift
		;;
	-*) die 2 "$usage" ;;
	*) lessons+=("$1") ;;
	esac
	shift
done

prepare_project
known=$(lesson_ids)
for id in ${lessons[@]+"${lessons[@]}"}; do
	grep -qxF -- "$id" <<<"$known" || die 2 "there is no lesson '$id'; there are: ${known//$'\n'/, }"
done
# shellcheck disable=SC2206 # one word for each id
[ ${#lessons[@]} -gt 0 ] || lessons=($known)

# With fixed frames a lesson that moves by itself is the same on every machine.
"$LAB_ROOT/tools/shared/run_with_patience.sh" 300 \
	"$godot" --headless --fixed-fps 60 --path "$LAB_ROOT" -s tools/checks/check_truth.gd -- \
	${options[@]+"${options[@]}"} "${lessons[@]}"
