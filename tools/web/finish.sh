#!/usr/bin/env bash
# Makes a web site of the exported demos: the engine once for all of them, compressed copies beside it, an index, links.
# Can be run again when single demos were exported anew. Usage: tools/web/finish.sh FOLDER [ADDRESS]
# ADDRESS is where the site will be: without it, previews of a page in chats have no picture.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

[ $# -ge 1 ] && [ -d "$1" ] || die 2 "usage: tools/web/finish.sh FOLDER [ADDRESS], the folder with the exported demos"
site=$(cd "$1" && pwd)
engine=$site/engine
engine_files=(js wasm audio.worklet.js audio.position.worklet.js)
is_engine_new=

# share_engine DEMO_FOLDER: a page that was finished before has no engine beside it any more.
share_engine() {
	[ -f "$1/index.wasm" ] || return 0
	local ending is_same=1
	for ending in "${engine_files[@]}"; do
		cmp -s "$1/index.$ending" "$engine/godot.$ending" || is_same=
	done
	if [ -n "$is_same" ]; then
		rm "${engine_files[@]/#/$1/index.}"
		return
	fi
	[ -z "$is_engine_new" ] || die 1 "the demos were exported with two different engines (the second: $1)"
	is_engine_new=1
	rm -rf "$engine"
	mkdir "$engine"
	for ending in "${engine_files[@]}"; do mv "$1/index.$ending" "$engine/godot.$ending"; done
}

# tidy DEMO_FOLDER: the pack gets the demo's name; the engine's start picture and icons are used by no page.
tidy() {
	[ ! -f "$1/index.pck" ] || mv "$1/index.pck" "$1/$(basename "$1").pck"
	rm -f "$1"/index.{png,icon.png,apple-touch-icon.png}
}

compress() {
	local file
	for file in "$engine"/godot.{js,wasm}; do
		[ -f "$file.gz" ] || gzip -9 --keep --no-name "$file"
		[ -f "$file.br" ] || ! command -v brotli >/dev/null || brotli -9 --keep "$file"
	done
}

for page in "$site"/*/index.html; do
	[ -f "$page" ] || die 1 "there is no exported demo in $site"
	share_engine "$(dirname "$page")"
	tidy "$(dirname "$page")"
done
compress
prepare_project
run_script web/write_pages.gd "$site" "${@:2}" >"$LAB_BUILD/write_pages.log" || {
	cat "$LAB_BUILD/write_pages.log" >&2
	die 1 "the pages of $site could not be written"
}
