#!/usr/bin/env bash
# Draws lessons, or all of them, and keeps the pictures: docs/pictures/<id>.png, and the lesson's card.png for the start
# screen. Usage: tools/commands/pictures.sh [LESSON...]
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

prepare_project
ids=$(lesson_ids)
for lesson in "$@"; do
	grep -qxF -- "$lesson" <<<"$ids" || die 2 "there is no lesson '$lesson'; there are: ${ids//$'\n'/, }"
done
# shellcheck disable=SC2086 # one word for each id
[ $# -gt 0 ] || set -- $ids
# Past every question, to the last step: a picture shows all that there is to see.
"$LAB_ROOT/tools/draw/draw.sh" "$godot" --press=lab_next_step*20 "$@"
run_script draw/keep_pictures.gd "$@"
