#!/usr/bin/env bash
# Runs the unit tests once more under GUT's stand-in, in a copy of the project, and compares what it counts with what
# the last `./lab test` left in build/test/junit.xml. The integration tests use the same asserts, and take ten times as
# long. Usage: tools/checks/compare_runners.sh
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

copy=$LAB_BUILD/stand_in_project
compared=tests/unit

# counts JUNIT_XML: scripts, tests, asserts and failed tests.
counts() {
	awk -v folder="\"$compared/" '/<testsuite / { counts = index($0, folder); scripts += counts > 0 }
		!counts { next }
		/<testcase / { tests++; match($0, /assertions="[0-9]+"/); asserts += substr($0, RSTART + 12, RLENGTH - 13) }
		/<failure / { failed++ }
		END { printf "%d scripts, %d tests, %d asserts, %d failed\n", scripts, tests, asserts, failed }' "$1"
}

if [ ! -f "$LAB_ROOT/addons/gut/gut.gd" ]; then
	echo "GUT is not here: there is nothing to compare its stand-in with"
	exit
fi
[ -f "$LAB_BUILD/test/junit.xml" ] || die 2 "run './lab test' first: there are no results to compare with"

rm -rf "$copy"
mkdir -p "$copy"
tar -c -C "$LAB_ROOT" --exclude=./.git --exclude=./.godot --exclude=./build --exclude=./addons/gut . | tar -x -C "$copy"
GUT_REPO=none "$copy/lab" test "-gdir=res://$compared" >"$LAB_BUILD/stand_in.log" 2>&1 || true
sed -n '/^What is wrong/,$p' "$LAB_BUILD/stand_in.log"
[ -f "$copy/build/test/junit.xml" ] || die 1 "the stand-in did not reach its end: see $LAB_BUILD/stand_in.log"

of_gut=$(counts "$LAB_BUILD/test/junit.xml")
of_stand_in=$(counts "$copy/build/test/junit.xml")
echo "In $compared, GUT ran $of_gut; its stand-in ran $of_stand_in"
[ "$of_gut" = "$of_stand_in" ] || die 1 "GUT and its stand-in do not count the same"
