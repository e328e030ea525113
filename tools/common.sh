# shellcheck shell=bash
# What every tool shares: where things are, how they speak. Sourced, never run.

LAB_ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
LAB_CACHE=${XDG_CACHE_HOME:-$HOME/.cache}/vec2-lab

GODOT_VERSION=4.6.3
GUT_VERSION=9.6.0
GUT_COMMIT=9f3edeb19df664ad32c369353d8d62dbb7b80673
GUT_PUBLIC_REPO=https://github.com/bitwes/Gut.git
GDTOOLKIT_VERSION=4.5.0

export LAB_ROOT LAB_CACHE GODOT_VERSION GUT_VERSION GUT_COMMIT GUT_PUBLIC_REPO GDTOOLKIT_VERSION

say() { printf '%s\n' "$*" >&2; }

# die CODE MESSAGE: one line on what is wrong and what is allowed; exit code 2 means "asked for wrongly".
die() {
	local code=$1
	shift
	say "lab: $*"
	exit "$code"
}
