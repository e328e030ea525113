#!/usr/bin/env bash
# Tries the stiff and extreme cases and prints a table; fails when one of them fails. With --fuzz: tries random worlds.
# Usage: tools/commands/stability.sh [--quick] [WORD]   (--quick: long cases in their quick form; WORD: only cases whose title holds it)
#        tools/commands/stability.sh --fuzz [MINUTES] [--seed S] [WORD]   (5 minutes, a new seed; WORD: only kinds whose name holds it)
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

usage="usage: ./lab stability [--quick] [WORD], or: ./lab stability --fuzz [MINUTES] [--seed S] [WORD]"

# run SCRIPT SECONDS_OF_SILENCE [OPTIONS]
run() {
	local script=$1 silence=$2
	shift 2
	prepare_project
	"$LAB_ROOT/tools/shared/run_with_patience.sh" "$silence" "$godot" --headless --path "$LAB_ROOT" -s "tools/report/$script.gd" -- "$@"
}

fuzz() {
	local minutes=5 seed=$((RANDOM * 30 + RANDOM % 30 + 1)) word='' status=0
	if [[ ${1:-} =~ ^[0-9.]+$ ]]; then
		[[ $1 =~ ^[0-9]{1,4}(\.[0-9]{1,3})?$ ]] || die 2 "the minutes must be from 0 to 9999, not '$1'; $usage"
		minutes=$1
		shift
	fi
	if [ "${1:-}" = --seed ]; then
		[[ ${2:-} =~ ^[1-9][0-9]{0,5}$ ]] || die 2 "--seed must be a whole number from 1 to 999999, not '${2:-}'; $usage"
		seed=$2
		shift 2
	fi
	[ $# -le 1 ] && [[ "${1:-}" != -* ]] || die 2 "$usage"
	word=${1:-}
	make_build_folder
	mkdir -p "$LAB_BUILD/fuzz"
	run fuzz 300 "--minutes=$minutes" "--seed=$seed" "--word=$word" || status=$?
	[ "$status" -le 2 ] || say "it was stopped while it tried this world: $(cat "$LAB_BUILD/fuzz/tried.txt")"
	exit "$status"
}

if [ "${1:-}" = --fuzz ]; then
	shift
	fuzz "$@"
fi

options=()
if [ "${1:-}" = --quick ]; then
	options+=("$1")
	shift
fi
[ $# -le 1 ] && [[ "${1:-}" != -* ]] || die 2 "$usage"
[ $# -eq 0 ] || options+=("--word=$1")
run stability 300 ${options[@]+"${options[@]}"}
