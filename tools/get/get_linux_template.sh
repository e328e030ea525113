#!/usr/bin/env bash
# Prints the folder of export templates that has the one for Linux: Godot's own where the official templates are
# installed, else one of the cache that is laid out like it, with the template of Debian's packages. What that makes runs
# on this machine only: it names the libraries in the cache. Usage: tools/get/get_linux_template.sh
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

template=linux_release.x86_64
official=${XDG_DATA_HOME:-${HOME:-}/.local/share}/godot/export_templates/$GODOT_VERSION.stable
[ "$(uname -s)" != Darwin ] || official="${HOME:-}/Library/Application Support/Godot/export_templates/$GODOT_VERSION.stable"
# Below a folder that can be Godot's XDG_DATA_HOME for one call.
ours=$LAB_CACHE/export_data/godot/export_templates/$GODOT_VERSION.stable
debian=$LAB_CACHE/godot-$GODOT_VERSION-debian
by_hand="install Godot's official export templates (in the editor: Editor > Manage Export Templates)"

if [ -f "$official/$template" ]; then
	echo "$official"
	exit
fi
if [ ! -f "$ours/$template" ]; then
	[ -d "$debian" ] || die 1 "the export template for Linux is missing: $by_hand"
	"$LAB_ROOT/tools/get/get_godot_debian.sh" "$debian" >/dev/null
	mkdir -p "$ours"
	cp "$debian/bin/godot-template-release" "$ours/$template.partial"
	mv "$ours/$template.partial" "$ours/$template"
fi
echo "$ours"
