#!/usr/bin/env bash
# Draws lessons, or all of them, and keeps the pictures: docs/pictures/<id>.png, and the lesson's card.png for the start
# screen. Usage: tools/commands/pictures.sh [LESSON...]
# Or draws what each row of docs/teaching.md opens, into build/pictures/teaching/, to be looked at:
# tools/commands/pictures.sh --teaching [WIDTHxHEIGHT [LANGUAGE [ROW...]]]
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

draw_row() {
	local row=$1 size=$2 language=$3 link
	link=$(sed -n "s/^| $row | [0-9]* | [^\`]*\`\([^\`]*\)\`.*/\1/p" "$LAB_ROOT/docs/teaching.md")
	[ -n "$link" ] || die 2 "docs/teaching.md has no row '$row'"
	"$LAB_ROOT/tools/draw/draw.sh" "$godot" "--size=$size" "$link&lang=$language"
	mkdir -p "$LAB_BUILD/pictures/teaching"
	mv "$LAB_BUILD/pictures/${link%%\?*}_$size.png" "$LAB_BUILD/pictures/teaching/${row}_${size}_$language.png"
}

draw_rows() {
	local size=${1:-1920x1080} language=${2:-en} row
	shift $(($# < 2 ? $# : 2))
	# shellcheck disable=SC2046 # one word for each row
	[ $# -gt 0 ] || set -- $(sed -n 's/^| \([0-9]*\) | [0-9]* | .*/\1/p' "$LAB_ROOT/docs/teaching.md")
	for row in "$@"; do draw_row "$row" "$size" "$language"; done
}

prepare_project
if [ "${1:-}" = --teaching ]; then
	shift
	draw_rows "$@"
	exit
fi
ids=$(lesson_ids)
for lesson in "$@"; do
	grep -qxF -- "$lesson" <<<"$ids" || die 2 "there is no lesson '$lesson'; there are: ${ids//$'\n'/, }"
done
# shellcheck disable=SC2086 # one word for each id
[ $# -gt 0 ] || set -- $ids
# Past every question, to the last step: a picture shows all that there is to see. Of the game it is a level with helpers.
level="aiming_game?level=7&aims=true&leads=true&bounces=true"
names=("${@/%aiming_game/"$level"}")
"$LAB_ROOT/tools/draw/draw.sh" "$godot" --press=lab_next_step*20 "${names[@]}"
"$LAB_ROOT/tools/draw/draw.sh" "$godot" --card --size=480x364 --press=lab_next_step*20 "${names[@]}"
run_script draw/keep_pictures.gd "$@"
