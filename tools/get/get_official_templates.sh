#!/usr/bin/env bash
# Puts Godot's official export templates where Godot looks for them (a download of more than 1 GB): what the editor does
# with Editor > Manage Export Templates, for machines without a screen. Usage: tools/get/get_official_templates.sh
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

# Those that the presets need.
wanted=(web_nothreads_release.zip linux_release.x86_64)
place=${XDG_DATA_HOME:-$HOME/.local/share}/godot/export_templates/$GODOT_VERSION.stable
release=$GODOT_RELEASES/$GODOT_VERSION-stable
archive=Godot_v$GODOT_VERSION-stable_export_templates.tpz

is_complete() {
	local file
	for file in "${wanted[@]}"; do [ -f "$place/$file" ] || return 1; done
}

if is_complete; then
	say "the official export templates are in $place"
	exit
fi
need curl curl ca-certificates && need unzip unzip || exit 1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
say "downloading $archive from $release"
curl -fsSL --connect-timeout 5 -o "$work/SHA512-SUMS.txt" "$release/SHA512-SUMS.txt" || die 1 "$release cannot be reached"
curl -fsSL --connect-timeout 5 --speed-limit 1000 --speed-time 30 -o "$work/$archive" "$release/$archive" ||
	die 1 "$archive did not arrive from $release"
sum=$(awk -v name="$archive" '$2 == name || $2 == "*" name {print $1}' "$work/SHA512-SUMS.txt")
[ -n "$sum" ] && [ "$sum" = "$(sha512_of "$work/$archive")" ] ||
	die 1 "$archive does not match the release's SHA-512 sum and was thrown away"
unzip -q -j "$work/$archive" "${wanted[@]/#/templates/}" -d "$work/unpacked"
mkdir -p "$place"
mv "${wanted[@]/#/$work/unpacked/}" "$place"
say "the official export templates are in $place now"
