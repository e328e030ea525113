#!/usr/bin/env bash
# Measures error against run time, and writes build/report/: error_vs_time.csv, report.md, a picture for each problem.
# Usage: tools/report.sh [--quick] [--peers] [--problems=NUMBER,...]
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "$0")/common.sh"

usage="usage: ./lab report [--quick] [--peers] [--problems=NUMBER,...]"
with_peers=
quick=
problems=
for argument; do
	case $argument in
		--peers) with_peers=1 ;;
		--quick) quick=$argument ;;
		--problems=*)
			[[ $argument =~ ^--problems=[1-7](,[1-7])*$ ]] ||
				die 2 "'$argument' is no list of problems; 1 to 7 are possible, such as --problems=1,7"
			problems=$argument
			;;
		*) die 2 "there is no option '$argument'; $usage" ;;
	esac
done

# The file `installed` is written last: an interrupted installation is begun anew.
get_libraries() {
	local wanted="box2d==$BOX2D_VERSION pymunk==$PYMUNK_VERSION"
	[ "$(cat "$venv/installed" 2>/dev/null)" != "$wanted" ] || return 0
	python3 -c 'import ensurepip, venv' 2>/dev/null ||
		install_packages "python3 with venv is missing" python3-venv || return 1
	say "installing $wanted into $venv"
	rm -rf "$venv"
	# shellcheck disable=SC2086 # two requirements, two words
	python3 -m venv "$venv" && "$venv/bin/pip" install --quiet --disable-pip-version-check $wanted >&2 &&
		echo "$wanted" >"$venv/installed"
}

measure_libraries() {
	get_libraries && run_script report/write_shots.gd ${quick:+"$quick"} >"$folder/peers.log" &&
		"$venv/bin/python" "$LAB_ROOT/tools/report/peers.py" "$folder/shots.json" "$folder/peers.json"
}

prepare_project
make_build_folder
folder=$LAB_BUILD/report
venv=$LAB_CACHE/peers-venv
mkdir -p "$folder"
rm -f "$folder"/*
if [ -n "$with_peers" ]; then
	measure_libraries || say "Box2D and Chipmunk could not be had or run: the report goes on without them"
fi
"$LAB_ROOT/tools/run_with_patience.sh" 120 "$godot" --headless --fixed-fps 60 --path "$LAB_ROOT" \
	-s tools/report/report.gd -- ${quick:+"$quick"} ${problems:+"$problems"}
rm -f "$folder/shots.json" "$folder/peers.json" "$folder/peers.log"
[ -s "$folder/report.md" ] || die 1 "no report was written; see what Godot said above"
say "written: build/report/report.md, error_vs_time.csv and a picture for each problem"
