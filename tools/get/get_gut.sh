#!/usr/bin/env bash
# Puts GUT into addons/gut: the copy that is there, the cache, $GUT_REPO, the public repository; else the stand-in.
# GUT_REPO=none asks for the stand-in. GODOT_VERSION decides which GUT: 9.6 is for Godot 4.6, 9.7 for Godot 4.7.
# Usage: tools/get/get_gut.sh [--try-all]   (asks the network again even where the stand-in is already in place)
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

case $GODOT_VERSION in
	4.[0-6] | 4.[0-6].*) GUT_VERSION=9.6.0 GUT_COMMIT=9f3edeb19df664ad32c369353d8d62dbb7b80673 ;;
	*) GUT_VERSION=9.7.0 GUT_COMMIT=3e53dbc69ff6ba4d975edf302bbce23c40686e1e ;;
esac
place=$LAB_ROOT/addons/gut
cached=$LAB_CACHE/gut-$GUT_VERSION
stand_in=$LAB_ROOT/addons/gut_standin/as_gut

is_gut() { grep -qs "^version=\"$GUT_VERSION\"" "$1/plugin.cfg"; }
is_stand_in() { grep -qs 'version=".*stand-in"' "$place/plugin.cfg"; }

# put FOLDER: does nothing when that is there already; the copy gets its name when it is whole.
put() {
	diff -rq -x '*.uid' -x .gdignore "$1" "$place" >/dev/null 2>&1 && return
	make_build_folder
	rm -rf "$LAB_BUILD/gut.partial" "$place"
	cp -R "$1" "$LAB_BUILD/gut.partial"
	rm -f "$LAB_BUILD/gut.partial/.gdignore"
	mkdir -p "$(dirname "$place")"
	mv "$LAB_BUILD/gut.partial" "$place"
}

# A network that swallows everything is noticed after some seconds; git alone would wait for minutes.
is_reachable() {
	[[ $1 != http* ]] || ! command -v curl >/dev/null || curl -s --connect-timeout 5 -o /dev/null "$1"
}

# fetch REPOSITORY: GUT's files of the pinned commit into the cache; git itself proves content by the commit's id.
fetch() {
	local work=$cached.partial got
	is_reachable "$1" || return 1
	rm -rf "$work"
	mkdir -p "$work"
	git init -q --bare "$work/repository"
	GIT_TERMINAL_PROMPT=0 git -C "$work/repository" fetch -q --depth 1 "$1" "$GUT_COMMIT" || return 1
	got=$(git -C "$work/repository" rev-parse FETCH_HEAD)
	if [ "$got" != "$GUT_COMMIT" ]; then
		say "$1 gave commit $got, not GUT $GUT_VERSION ($GUT_COMMIT)"
		return 1
	fi
	git -C "$work/repository" archive FETCH_HEAD addons/gut | tar -x -C "$work"
	is_gut "$work/addons/gut" || return 1
	rm -rf "$cached"
	mv "$work/addons/gut" "$cached"
	rm -rf "$work"
}

from_git() {
	need git git ca-certificates || return 1
	if [ -n "${GUT_REPO:-}" ]; then
		say "getting GUT $GUT_VERSION from GUT_REPO"
		fetch "$GUT_REPO" && return
		say "GUT_REPO=$GUT_REPO holds no GUT $GUT_VERSION (commit $GUT_COMMIT): trying the public repository"
	fi
	say "getting GUT $GUT_VERSION from $GUT_PUBLIC_REPO"
	fetch "$GUT_PUBLIC_REPO"
}

if [ "${GUT_REPO:-}" = none ]; then
	put "$stand_in"
elif is_gut "$place"; then
	exit
elif is_gut "$cached"; then
	put "$cached"
elif is_stand_in && [ -z "${GUT_REPO:-}" ] && [ "${1:-}" != --try-all ]; then
	put "$stand_in"
	say "GUT is not here: its small stand-in runs the tests ('./lab setup' tries again to get GUT)"
elif from_git; then
	put "$cached"
else
	rm -rf "$cached.partial"
	put "$stand_in"
	say "GUT cannot be had: its small stand-in runs the tests ('./lab setup' tries again to get GUT)"
fi
