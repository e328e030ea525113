#!/usr/bin/env bash
# Gets what the lab needs and says what it found. Usage: tools/commands/setup.sh
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

godot=$("$LAB_ROOT/tools/get/get_godot.sh")
know_engine "$godot"
say "Godot $("$godot" --version) is $godot"
"$LAB_ROOT/tools/get/get_gut.sh" --try-all
say "$(sed -n 's/^name="\(.*\)"/\1/p' "$LAB_ROOT/addons/gut/plugin.cfg")" \
	"$(sed -n 's/^version="\(.*\)"/\1/p' "$LAB_ROOT/addons/gut/plugin.cfg") is addons/gut"
