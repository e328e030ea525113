#!/usr/bin/env bash
# Measures error against run time, and writes build/report/: error_vs_time.csv, report.md, a picture for each problem.
# Usage: tools/report.sh [--quick] [--peers] [--problems=NUMBER,...]
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "$0")/common.sh"

usage="usage: ./lab report [--quick] [--peers] [--problems=NUMBER,...]"
with_peers=
options=()
for argument; do
	case $argument in
		--peers) with_peers=1 ;;
		--quick) options+=("$argument") ;;
		--problems=*)
			[[ $argument =~ ^--problems=[1-7](,[1-7])*$ ]] ||
				die 2 "'$argument' is no list of problems; 1 to 7 are possible, such as --problems=1,7"
			options+=("$argument")
			;;
		*) die 2 "there is no option '$argument'; $usage" ;;
	esac
done

prepare_project
make_build_folder
folder=$LAB_BUILD/report
mkdir -p "$folder"
rm -f "$folder"/*
"$LAB_ROOT/tools/run_with_patience.sh" 120 "$godot" --headless --fixed-fps 60 --path "$LAB_ROOT" \
	-s tools/report/report.gd -- ${options[@]+"${options[@]}"}
