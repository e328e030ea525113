#!/usr/bin/env bash
# Begins a lesson as a copy of the smallest one, at the end of the index. Usage: tools/commands/new_lesson.sh ID
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

[ $# -eq 1 ] || die 2 "usage: ./lab new_lesson ID, such as: ./lab new_lesson my_lesson"
prepare_project
run_script lessons/new_lesson.gd "$1"
# The import gives the new scripts their uids.
"$LAB_ROOT/tools/shared/import.sh" "$godot"
