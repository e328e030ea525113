#!/usr/bin/env bash
# Serves the demos for the browser on this machine, and prints the address; exports them first where they are missing or
# older than the project. Usage: tools/serve.sh [PORT]
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "$0")/common.sh"

site=$LAB_BUILD/export/web

is_port() { [[ $1 =~ ^[0-9]{1,5}$ ]] && [ "$1" -ge 1 ] && [ "$1" -le 65535 ]; }

is_up_to_date() {
	[ -f "$site/index.html" ] || return 1
	local newer
	newer=$(cd "$LAB_ROOT" && find scripts scenes assets tools/web project.godot export_presets.cfg \
		-newer "$site/index.html" -print 2>/dev/null)
	[ -z "$newer" ]
}

[ $# -le 1 ] || die 2 "usage: ./lab serve [PORT]"
[ $# -eq 0 ] || is_port "$1" || die 2 "'$1' is no port; 1 to 65535 are possible"
need python3 python3 || exit 2
is_up_to_date || "$LAB_ROOT/lab" export web
exec python3 "$LAB_ROOT/tools/web/server.py" "$site" "$@"
