#!/usr/bin/env bash
# Measures error against run time, and writes build/report/: error_vs_time.csv, report.md, a picture for each problem.
# Usage: tools/commands/report.sh [--quick] [--libraries] [--problems=NUMBER,...] [--against FILE]... [--also FILE]...
# --against FILE: an error_vs_time.csv of an older version: the report then has the ratio of the run times of each row
# that is in both, with its spread. Several of them, and with --also several of the present version, give a better spread.
# --libraries measures Box2D and Chipmunk, too; --peers is its old name.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

usage="usage: ./lab report [--quick] [--libraries] [--problems=NUMBER,...] [--against FILE]... [--also FILE]..."
with_libraries=
quick=
problems=
compared=()

# keep_table OPTION FILE: a copy, because the new report replaces what is in build/report/.
keep_table() {
	[ -n "${2:-}" ] || die 2 "'$1' needs the error_vs_time.csv of another report; $usage"
	[[ $(head -n 1 "$2" 2>/dev/null) == problem,method,setting,peer,run_time_us,* ]] ||
		die 2 "'$2' is no error_vs_time.csv of a report; $usage"
	make_build_folder
	mkdir -p "$LAB_BUILD/compared_reports"
	cp "$2" "$LAB_BUILD/compared_reports/${#compared[@]}.csv"
	compared+=("$1=$LAB_BUILD/compared_reports/${#compared[@]}.csv")
}

while [ $# -gt 0 ]; do
	argument=$1
	shift
	case $argument in
		--against | --also)
			keep_table "$argument" "${1:-}"
			shift
			;;
		--libraries | --peers) with_libraries=1 ;;
		--quick) quick=$argument ;;
		--problems=*)
			[[ $argument =~ ^--problems=([1-9]|1[01])(,([1-9]|1[01]))*$ ]] ||
				die 2 "'$argument' is no list of problems; 1 to 11 are possible, such as --problems=1,11"
			problems=$argument
			;;
		*) die 2 "there is no option '$argument'; $usage" ;;
	esac
done

measure_libraries() {
	bring_python_packages "$venv" "box2d==$BOX2D_VERSION" "pymunk==$PYMUNK_VERSION" &&
		run_script report/write_shots.gd ${quick:+"$quick"} >"$folder/libraries.log" &&
		"$venv/bin/python" "$LAB_ROOT/tools/report/libraries.py" "$folder/shots.json" "$folder/libraries.json"
}

prepare_project
make_build_folder
folder=$LAB_BUILD/report
venv=$LAB_CACHE/libraries-venv
mkdir -p "$folder"
rm -f "$folder"/*
if [ -n "$with_libraries" ]; then
	measure_libraries || say "Box2D and Chipmunk could not be had or run: the report goes on without them"
fi
"$LAB_ROOT/tools/shared/run_with_patience.sh" 120 "$godot" --headless --fixed-fps 60 --path "$LAB_ROOT" \
	-s tools/report/report.gd -- ${quick:+"$quick"} ${problems:+"$problems"} \
	${compared[@]+"${compared[@]}"}
rm -f "$folder/shots.json" "$folder/libraries.json" "$folder/libraries.log"
[ -s "$folder/report.md" ] || die 1 "no report was written; see what Godot said above"
say "written: build/report/report.md, rubric.html, error_vs_time.csv and a picture for each problem"
