#!/usr/bin/env bash
# Opens the lab, or one lesson, or a board by its link. Without a display it draws them into build/pictures/ instead.
# Usage: tools/commands/run.sh [LESSON|LINK [OPTION...]]   (LINK: such as 'dot_product?a=7,1'; options for pictures: see
# tools/draw/draw.sh)
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

prepare_project
ids=$(lesson_ids)
if [ $# -ge 1 ]; then
	link=${1##*#}
	# The smallest lesson is not in the index.
	grep -qxF -- "${link%%\?*}" <<<"$ids"$'\nsmallest_lesson' ||
		die 2 "there is no lesson '${link%%\?*}'; there are: ${ids//$'\n'/, }"
	set -- "$link" "${@:2}"
fi

if has_display; then
	use_drivers_beside_godot
	exec "$godot" --path "$LAB_ROOT" ${1:+-- "--lesson=$1"}
fi
say "there is no display: drawing into build/pictures/"
if [ $# -ge 1 ]; then
	"$LAB_ROOT/tools/draw/draw.sh" "$godot" "${@:2}" "$1"
else
	# shellcheck disable=SC2086 # one word for each id
	"$LAB_ROOT/tools/draw/draw.sh" "$godot" start_screen $ids
fi
