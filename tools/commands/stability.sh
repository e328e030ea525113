#!/usr/bin/env bash
# Tries the stiff and extreme cases and prints a table; fails when one of them fails.
# Usage: tools/commands/stability.sh [--quick] [WORD]   (--quick: long cases in their quick form; WORD: only cases whose title holds it)
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

options=()
if [ "${1:-}" = --quick ]; then
	options+=("$1")
	shift
fi
[ $# -le 1 ] && [[ "${1:-}" != -* ]] || die 2 "usage: ./lab stability [--quick] [WORD]"
[ $# -eq 0 ] || options+=("--word=$1")

prepare_project
"$LAB_ROOT/tools/shared/run_with_patience.sh" 300 "$godot" --headless --path "$LAB_ROOT" -s tools/report/stability.gd -- ${options[@]+"${options[@]}"}
