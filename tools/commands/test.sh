#!/usr/bin/env bash
# Runs the tests; green only when something was run and nothing whatever was wrong. Usage: tools/commands/test.sh [GUT OPTIONS]
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

results=$LAB_BUILD/test
report=$results/report.txt

# With fixed frames a second of waiting takes no second, and a test does not depend on how fast the machine is.
run_tests() {
	"$LAB_ROOT/tools/shared/run_with_patience.sh" 300 \
		"$godot" --headless --fixed-fps 60 --path "$LAB_ROOT" -s addons/gut/gut_cmdln.gd "$@" |
		tee "$results/log.txt" | awk -f "$LAB_ROOT/tools/checks/hide_watched_messages.awk" | tee "$results/shown.txt"
}

# One line for each thing that is wrong.
problems() {
	if [ -f "$report" ]; then
		sed -n 's/^problem //p' "$report"
	else
		echo "the run did not reach its end: no test was found, or Godot stopped"
	fi
	engine_messages "$results/shown.txt"
}

tell_slowest() {
	[ -f "$results/junit.xml" ] || return 0
	printf '\nThe slowest test scripts:\n'
	awk -f "$LAB_ROOT/tools/checks/slowest_scripts.awk" "$results/junit.xml" | sort -rn | sed -n 1,10p
}

trap 'printf "\n0 passed, 1 failed\n"' EXIT
prepare_project
trap - EXIT
make_build_folder
mkdir -p "$results"
rm -f "$report" "$results/junit.xml"

[ -t 1 ] || set -- "$@" -gdisable_colors
# A script that is named is run alone.
[[ " $*" != *" -gtest"* || " $*" == *" -gdir"* ]] || set -- "$@" -gdir=

status=0
run_tests "$@" || status=$?
tell_slowest
found=$(problems)
[ "$status" -eq 0 ] || [ -n "$found" ] || found="Godot ended with exit code $status"

failed=0
if [ -n "$found" ]; then
	failed=$(printf '%s\n' "$found" | grep -c '')
	printf '\nWhat is wrong:\n%s\n' "$found"
fi
passed=$(sed -n 's/^passed //p' "$report" 2>/dev/null || true)
printf '\n%d passed, %d failed\n' "${passed:-0}" "$failed"
[ "$failed" -eq 0 ]
