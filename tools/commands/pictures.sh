#!/usr/bin/env bash
# Draws all lessons and keeps the pictures: docs/pictures/<id>.png, and the lesson's card.png for the start screen.
# Usage: tools/commands/pictures.sh
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

prepare_project
# shellcheck disable=SC2046 # one word for each id
"$LAB_ROOT/tools/draw/draw.sh" "$godot" $(lesson_ids)
run_script draw/keep_pictures.gd
