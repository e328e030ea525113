#!/usr/bin/env bash
# Serves the demos for the browser on this machine, and prints the address; exports them first where they are missing or
# older than the project. Usage: tools/commands/serve.sh [PORT]
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"
# shellcheck source-path=SCRIPTDIR source=../web/site.sh
. "$(dirname "$0")/../web/site.sh"

is_port() { [[ $1 =~ ^[0-9]{1,5}$ ]] && [ "$1" -ge 1 ] && [ "$1" -le 65535 ]; }

[ $# -le 1 ] || die 2 "usage: ./lab serve [PORT]"
[ $# -eq 0 ] || is_port "$1" || die 2 "'$1' is no port; 1 to 65535 are possible"
need python3 python3 || exit 2
bring_site_up_to_date
exec python3 "$LAB_ROOT/tools/web/server.py" "$site" "$@"
