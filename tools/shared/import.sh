#!/usr/bin/env bash
# Lets Godot import the project when a file has changed since the last time; refuses a project that does not
# import without an error or a warning. Usage: tools/shared/import.sh GODOT
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "$0")/common.sh"

godot=$1
imported=$LAB_ROOT/.godot/lab_imported
log=$LAB_BUILD/import.log

is_up_to_date() {
	[ -f "$imported" ] || return 1
	local newer
	newer=$(find "$LAB_ROOT" -mindepth 1 \( -name .git -o -path "$LAB_ROOT/.godot" -o -path "$LAB_BUILD" \) -prune \
		-o -newer "$imported" -print)
	[ -z "$newer" ]
}

is_up_to_date && exit
say "importing the project"
make_build_folder
if ! "$godot" --headless --path "$LAB_ROOT" --import >"$log" 2>&1 </dev/null || [ -n "$(messages_of_editor "$log")" ]; then
	grep -vE '^.?\[|^$' "$log" >&2
	die 1 "the project does not import cleanly; all that Godot said is in $log"
fi
touch "$imported"
