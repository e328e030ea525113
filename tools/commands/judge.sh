#!/usr/bin/env bash
# Judges hand-ins of the workshop: each folder inside FOLDER is one. A line for each exercise that is begun, with fields
# between tabs. Usage: tools/commands/judge.sh FOLDER [NAME ...]
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

[ $# -gt 0 ] && [ -d "$1" ] || die 2 "usage: ./lab judge FOLDER [NAME ...], with a folder for each hand-in inside FOLDER"
folder=$(cd "$1" && pwd)
shift
prepare_project
"$LAB_ROOT/tools/shared/run_with_patience.sh" 120 \
	"$godot" --headless --path "$LAB_ROOT" -s tools/checks/judge_hand_ins.gd -- "$folder" "$@" | sed '1,/^$/d'
