#!/usr/bin/env bash
# Exports the whole lab and the lessons as demos of their own into build/export/.
# Usage: tools/commands/export.sh linux|web|all [--address=https://...] [NAME...]   (NAME: `lab` or a lesson's id)
# With the address at which the site will be, its pages have a picture in the previews of chats: those take no other.
#        tools/commands/export.sh presets                   (only brings export_presets.cfg up to date)
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

usage="usage: ./lab export linux|web|all [--address=https://...] [lab|LESSON ...]"
logs=$LAB_BUILD/export/logs

platforms_of() {
	case $1 in
		linux | web) echo "$1" ;;
		all) echo "linux web" ;;
		*) die 2 "there is no platform '$1' to export to; $usage" ;;
	esac
}

# names_of [NAME...]: every demo that there is, or those that were asked for, when each of them is one.
names_of() {
	local known name
	known=lab$'\n'$(demo_ids)
	for name in "$@"; do
		grep -qxF -- "$name" <<<"$known" || die 2 "there is no demo '$name'; there are: ${known//$'\n'/, }"
	done
	# shellcheck disable=SC2086 # one word for each
	[ $# -gt 0 ] || set -- $known
	echo "$@"
}

write_presets() {
	local log=$LAB_BUILD/write_presets.log status=0
	run_script export/write_presets.gd >"$log" || status=$?
	grep '^lab: ' "$log" >&2 || true
	engine_messages "$log" >&2
	[ "$status" -eq 0 ] || die 1 "the export presets could not be written; all that Godot said is in $log"
}

# A stopped export leaves Godot's lists of classes and ids as the pack wanted them: the next import mends them.
forget_import() { rm -f "$LAB_ROOT/.godot/lab_imported"; }

# Gets the template for a platform; sets `data_home` where it is one in the cache, for which Godot needs another home.
get_template() {
	local folder
	folder=$("$LAB_ROOT/tools/get/get_$1_template.sh") || exit 1
	data_home=
	[[ $folder != "$LAB_CACHE"/* ]] || data_home=${folder%/godot/export_templates/*}
}

# export_demo PLATFORM NAME FILE
export_demo() {
	local log=$logs/$1_$2.log status=0
	rm -rf "$(dirname "$3")"
	mkdir -p "$(dirname "$3")"
	env ${data_home:+"XDG_DATA_HOME=$data_home"} "$LAB_ROOT/tools/shared/run_with_patience.sh" 120 \
		"$godot" --headless --path "$LAB_ROOT" --export-release "$1 $2" "$3" >"$log" || status=$?
	if [ "$status" -ne 0 ] || [ -n "$(messages_of_editor "$log")" ] || [ ! -f "$3" ]; then
		messages_of_editor "$log" >&2
		die 1 "'$2' could not be exported for $1; all that Godot said is in $log"
	fi
}

# share_program FILE: the program is the same in every demo, 80 MB of it; on the disk it lies once.
share_program() {
	if cmp -s "$program" "$1"; then ln -f "$program" "$1"; fi
	program=$1
}

# export_and_tell PLATFORM NAME: prints a line with the size of the pack.
export_and_tell() {
	local folder=$LAB_BUILD/export/$1/$2 begun=$SECONDS pack
	if [ "$1" = linux ]; then
		export_demo linux "$2" "$folder/$2.x86_64"
		share_program "$folder/$2.x86_64"
		pack=$folder/$2.pck
	else
		export_demo web "$2" "$folder/index.html"
		pack=$folder/index.pck
	fi
	number=$((number + 1))
	printf '[%d/%d] %s for %s: a pack of %d KB in build/export/%s/%s, after %d s\n' "$number" "$total" "$2" "$1" \
		$(($(wc -c <"$pack") / 1000)) "$1" "$2" $((SECONDS - begun))
}

[ $# -ge 1 ] || die 2 "$usage"
if [ "$1" != presets ]; then
	platforms=$(platforms_of "$1")
fi
address=
if [[ ${2:-} == --address=* ]]; then
	address=${2#--address=}
	[[ $address =~ ^https?://[^[:space:]]+$ ]] || die 2 "the address must begin with http:// or https://, not '$address'"
	set -- "$1" "${@:3}"
fi
prepare_project
make_build_folder
write_presets
[ "$1" != presets ] || exit 0
names=$(names_of "${@:2}")

# A missing template is found before the first export.
for platform in $platforms; do get_template "$platform"; done
mkdir -p "$logs"
trap forget_import INT TERM
number=0
program=
total=$(wc -w <<<"$(for platform in $platforms; do echo "$names"; done)")
for platform in $platforms; do
	get_template "$platform"
	for name in $names; do export_and_tell "$platform" "$name"; done
done
[[ $platforms != *web* ]] || "$LAB_ROOT/tools/web/finish.sh" "$LAB_BUILD/export/web" ${address:+"$address"}
