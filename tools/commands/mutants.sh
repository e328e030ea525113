#!/usr/bin/env bash
# Checks the tests: puts one mistake after another into a copy of the project and sees which test finds it.
# Usage: tools/commands/mutants.sh [--quick] [PATTERN]   (--quick: the named mistakes and 40 of the others; PATTERN: only
# mutants whose kind, file, line or title holds it). MUTANTS_AT_ONCE=1 leaves a core free.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

folder=$LAB_BUILD/mutants
at_once=${MUTANTS_AT_ONCE:-2}
# A test run hangs if it prints nothing for this long, or has used up this much of a core.
silence_seconds=20
processor_seconds=30

check_arguments() {
	[ "${1:-}" != --quick ] || shift
	[ $# -le 1 ] && [[ "${1:-}" != -* ]] || die 2 "usage: ./lab mutants [--quick] [PATTERN]"
	[[ $at_once =~ ^[1-9]$ ]] || die 2 "MUTANTS_AT_ONCE is '$at_once'; 1 to 9 are possible"
}

# write_mutants [--quick] [PATTERN]: the mutants and their list; dies when a written-down one no longer fits.
write_mutants() {
	local log=$folder/write.log
	"$godot" --headless --path "$LAB_ROOT" -s tools/mutants/write_mutants.gd -- "$@" >"$log" 2>&1 </dev/null || {
		sed -n 's/^problem //p' "$log" >&2
		die 1 "no mutants were made; $log says more"
	}
	[ -s "$folder/list.tsv" ] || die 2 "no mutant fits '$*'"
}

copy_project() {
	mkdir -p "$1"
	tar -c -C "$LAB_ROOT" --exclude=./.git --exclude=./build . | tar -x -C "$1"
}

# tests_for COPY FILE: the folder with the tests for a file of scripts/, or the nearest one above it.
tests_for() {
	local tests
	tests=$(dirname "tests/unit/${2#scripts/}")
	while [ ! -d "$1/$tests" ]; do tests=$(dirname "$tests"); done
	echo "$tests"
}

# run_tests COPY FILE: the unit tests that bear on FILE.
run_tests() {
	local options=(-gdir=res://tests/unit "-gselect=test_$(basename "$2" .gd)") tests
	tests=$(tests_for "$1" "$2")
	[ "$tests" = tests/unit ] || options=("-gdir=res://$tests")
	ulimit -S -t "$processor_seconds"
	"$LAB_ROOT/tools/shared/run_with_patience.sh" "$silence_seconds" "$godot" --headless --fixed-fps 60 --path "$1" \
		-s addons/gut/gut_cmdln.gd -gdisable_colors "${options[@]}"
}

# verdict COPY FILE: what the tests say; the run is broken off at the first failure.
verdict() {
	local report=$1/build/test/report.txt status=0 said
	rm -f "$report"
	said=$(run_tests "$@" 2>/dev/null | awk -f "$LAB_ROOT/tools/mutants/first_failure.awk") || status=$?
	if [ -z "$said" ] && [ -f "$report" ]; then
		said=$(sed -n 's/^problem /killed by /p' "$report" | head -n 1)
		said=${said:-SURVIVED}
	elif [ -z "$said" ] && [ "$status" -eq $((128 + $(kill -l XCPU))) ]; then
		said="killed by the time limit"
	fi
	printf '%s\n' "${said:-killed by the end of Godot}"
}

# try_mutant COPY NUMBER FILE
try_mutant() {
	cp "$folder/$2" "$1/$3"
	verdict "$1" "$3"
	cp "$LAB_ROOT/$3" "$1/$3"
}

# try_share FIRST: every at_once-th mutant, a line each, in a copy of the project of its own.
try_share() {
	local number kind file line title result said
	while IFS=$'\t' read -r number kind file line title; do
		[ $((number % at_once)) -eq "$1" ] || continue
		result="DOES NOT COMPILE"
		[ ! -f "$folder/$number" ] || result=$(try_mutant "$folder/copy_$1" "$number" "$file")
		said="$kind, $file:$line, $title: $result"
		printf '%s\t%s\t%s\t%s\n' "$number" "$kind" "$result" "$said" >"$folder/$number.result"
		printf '[%d/%d] %s\n' "$number" "$total" "$said"
	done <"$folder/list.tsv"
}

# Without a mistake all tests must be green, or a kill means nothing.
check_tests_without_mistake() {
	local file said
	cut -f 3 "$folder/list.tsv" | sort -u | while read -r file; do
		said=$(verdict "$folder/copy_0" "$file")
		[ "$said" = SURVIVED ] || die 1 "the tests of $file are not green without any mistake: $said"
	done
}

check_arguments "$@"
prepare_project
make_build_folder
rm -rf "$folder"
mkdir -p "$folder"
write_mutants "$@"
total=$(grep -c '' "$folder/list.tsv")
say "$total mutants, $at_once at a time"
for ((share = 0; share < at_once; share++)); do copy_project "$folder/copy_$share"; done
check_tests_without_mistake
trap 'kill $(jobs -p) 2>/dev/null || true' EXIT
for ((share = 0; share < at_once; share++)); do try_share "$share" & done
wait
rm -rf "$folder"/copy_*
cat "$folder"/*.result | sort -n | awk -F '\t' -f "$LAB_ROOT/tools/mutants/table.awk"
