#!/usr/bin/env bash
# Downloads the official Godot release for this platform, checked against the release's own SHA-512 sums.
# Prints the path of the program. Usage: tools/get/get_godot_official.sh FOLDER
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

[ $# -eq 1 ] || die 2 "usage: tools/get/get_godot_official.sh FOLDER"
folder=$1
work=$folder.partial
release=$GODOT_RELEASES/$GODOT_VERSION-stable

case $(uname -sm) in
	"Linux x86_64") platform=linux.x86_64 program=godot ;;
	"Linux aarch64") platform=linux.arm64 program=godot ;;
	Darwin*) platform=macos.universal program=Godot.app/Contents/MacOS/Godot ;;
	*) die 2 "Godot's official releases are not for $(uname -sm)" ;;
esac
archive=Godot_v$GODOT_VERSION-stable_$platform.zip

# fetch NAME [CURL OPTIONS]: goes on where an interrupted download stopped; without `.partial` it is complete.
fetch() {
	local file=$1
	shift
	curl -fL --connect-timeout 5 --speed-limit 1000 --speed-time 30 "$@" -o "$work/$file.partial" "$release/$file" &&
		mv "$work/$file.partial" "$work/$file"
}

# A server that cannot go on from the middle (curl: 22, 33, 36) is asked for the whole.
fetch_archive() {
	local status=0
	fetch "$archive" -C - || status=$?
	case $status in
		22 | 33 | 36) fetch "$archive" ;;
		*) return "$status" ;;
	esac
}

is_genuine() {
	local wanted
	wanted=$(awk -v name="$archive" '$2 == name || $2 == "*" name {print $1}' "$work/SHA512-SUMS.txt")
	[ -n "$wanted" ] && [ "$wanted" = "$(sha512_of "$work/$archive")" ]
}

need curl curl ca-certificates || exit 1
need unzip unzip || exit 1
mkdir -p "$work"
fetch SHA512-SUMS.txt -sS || die 1 "$release cannot be reached"

if [ ! -f "$work/$archive" ]; then
	say "downloading $archive from $release"
	fetch_archive || die 1 "$archive did not arrive; what is there is kept, and the next try goes on from it"
fi
if ! is_genuine; then
	rm -f "$work/$archive"
	die 1 "$archive does not match the release's SHA-512 sum and was thrown away"
fi

rm -rf "$work/unpacked" "$folder"
unzip -q "$work/$archive" -d "$work/unpacked"
[ "$program" != godot ] || mv "$work/unpacked/${archive%.zip}" "$work/unpacked/godot"
chmod +x "$work/unpacked/$program"
"$work/unpacked/$program" --version >/dev/null || die 1 "the downloaded Godot does not start on this system"
mv "$work/unpacked" "$folder"
rm -rf "$work"
echo "$folder/$program"
