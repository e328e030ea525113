#!/usr/bin/env bash
# Makes a small project that has this project's test runner, and the tests of cases/; only there their names begin
# with test_. Usage: make_project.sh FOLDER
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
project=$(cd "$here/../../.." && pwd)
rm -rf "$1"
mkdir -p "$1/addons" "$1/tests/support"
printf 'config_version=5\n\n[application]\n\nconfig/name="Runner test"\n' >"$1/project.godot"
cp -R "$project/lab" "$project/tools" "$project/.gutconfig.json" "$1"
cp -R "$project/addons/gut" "$project/addons/gut_standin" "$1/addons"
cp "$project"/tests/support/run_*.gd "$project/tests/support/scripts_on_disk.gd" "$1/tests/support"
mkdir -p "$1/cases/nothing"
for file in "$here"/cases/*/*.gd; do
	case=$(basename "$(dirname "$file")")
	mkdir -p "$1/cases/$case"
	cp "$file" "$1/cases/$case/test_$(basename "$file")"
done
