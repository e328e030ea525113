#!/usr/bin/env bash
# Prints the path of a Godot 4.5 or newer: $GODOT, the PATH, the cache, the official release, Debian's packages.
# Usage: tools/get/get_godot.sh
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

by_hand="install Godot 4.5 or newer from https://godotengine.org/download and set GODOT to its program"

version_of() { "$1" --version 2>/dev/null | tail -n 1; }

is_new_enough() {
	[[ $(version_of "$1" || true) =~ ^([0-9]+)\.([0-9]+) ]] || return 1
	local major=${BASH_REMATCH[1]} minor=${BASH_REMATCH[2]}
	[ "$major" -gt 4 ] || { [ "$major" -eq 4 ] && [ "$minor" -ge 5 ]; }
}

from_variable() {
	command -v "$GODOT" >/dev/null ||
		die 2 "GODOT=$GODOT is no program; set it to Godot 4.5 or newer, or unset it"
	is_new_enough "$GODOT" ||
		die 2 "GODOT=$GODOT says its version is '$(version_of "$GODOT" || true)'; 4.5 or newer is needed"
	command -v "$GODOT"
}

from_path() {
	local name
	for name in godot godot4; do
		command -v "$name" >/dev/null || continue
		if is_new_enough "$name"; then
			command -v "$name"
			return
		fi
		say "$name on the PATH is '$(version_of "$name" || true)', older than 4.5: looking further"
	done
	return 1
}

from_cache() {
	local program
	for program in godot-$GODOT_VERSION/{godot,Godot.app/Contents/MacOS/Godot} godot-$GODOT_VERSION-debian/bin/godot; do
		if [ -x "$LAB_CACHE/$program" ]; then
			echo "$LAB_CACHE/$program"
			return
		fi
	done
	return 1
}

from_network() {
	case $(uname -sm) in
		"Linux x86_64" | "Linux aarch64" | Darwin*) ;;
		*) die 2 "there is no Godot to download for $(uname -sm): $by_hand" ;;
	esac
	"$LAB_ROOT/tools/get/get_godot_official.sh" "$LAB_CACHE/godot-$GODOT_VERSION" && return
	# Debian has Godot 4.6 only.
	[[ $GODOT_VERSION == 4.6* ]] && [ "$(uname -sm)" = "Linux x86_64" ] && command -v apt-get >/dev/null &&
		"$LAB_ROOT/tools/get/get_godot_debian.sh" "$LAB_CACHE/godot-$GODOT_VERSION-debian" && return
	die 1 "Godot could not be had: $by_hand"
}

if [ -n "${GODOT:-}" ]; then
	from_variable
else
	from_path || from_cache || from_network
fi
