#!/usr/bin/env bash
# Opens a fresh copy of the project in the real editor, without GUT and then with it: opens, saves and closes each scene,
# opens and closes the export window. Fails when the editor prints an error or a warning, or when a file has changed.
# Usage: tools/editor/check_editor.sh [--keep]   (--keep: takes the files over as the editor has written them)
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"
# shellcheck source-path=SCRIPTDIR source=../draw/screen.sh
. "$(dirname "$0")/../draw/screen.sh"
# shellcheck source-path=SCRIPTDIR source=editor.sh
. "$(dirname "$0")/editor.sh"

# Seconds without a line after which the editor is stopped: it says nothing while it reads a fresh project for the first
# time, which takes a minute on a busy machine.
PATIENCE=180
keep=
case ${1:-} in
	--keep) keep=1 ;;
	"") ;;
	*) die 2 "usage: tools/editor/check_editor.sh [--keep]" ;;
esac

enable_plugin() {
	sed -i.before 's|^enabled=PackedStringArray(\(.*\))|enabled=PackedStringArray(\1, "res://tools/editor/plugin.cfg")|' \
		"$copy/project.godot"
	rm "$copy/project.godot.before"
}

# use_editor NAME SCENE...: says what is wrong.
use_editor() {
	local name=$1 status=0 said changed
	shift
	log="$LAB_BUILD/editor_${name// /_}.log"
	"${at_home[@]}" "$LAB_ROOT/tools/shared/run_with_patience.sh" "$PATIENCE" "$godot" --editor --path "$copy" \
		--audio-driver Dummy --rendering-driver opengl3 -- "$@" >"$log" || status=$?
	said=$(said_by_editor "$log")
	changed=$(in_copy status --short)
	if [ "$status" -eq 0 ] && grep -q '^editor: done$' "$log" && [ -z "$said$changed" ]; then
		echo "ok: the editor $name, $# scenes"
		return
	fi
	echo "FAILED: the editor $name (exit code $status); its log is $log"
	printf '%s\n' "$said" "$changed"
	failed=1
}

take_over() {
	local file
	in_copy diff --name-only -z -- . ':!project.godot' | while IFS= read -r -d '' file; do
		cp "$copy/$file" "$LAB_ROOT/$file"
		echo "taken over: $file"
	done
}

need git git || exit 2
prepare_project
make_build_folder
trap close_screen EXIT
open_screen
use_drivers_beside_godot
scenes=()
while IFS= read -r scene; do
	scenes+=("res://${scene#"$LAB_ROOT"/}")
done < <(find "$LAB_ROOT/scenes" -name '*.tscn' | sort)

failed=0
make_copy
enable_plugin
remember_copy
use_editor "without GUT" "${scenes[@]}"
[ -z "$keep" ] || take_over
if [ -f "$LAB_ROOT/addons/gut/gut.gd" ]; then
	in_copy checkout -q .
	rm -r "$copy/addons/gut"
	cp -R "$LAB_ROOT/addons/gut" "$copy/addons"
	use_editor "with GUT" "${scenes[0]}"
	grep -q "^editor: GUT's panel is there" "$log" || { echo "FAILED: GUT's panel is not there" && failed=1; }
fi
exit "$failed"
