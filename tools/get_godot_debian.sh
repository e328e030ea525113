#!/usr/bin/env bash
# Brings Godot from Debian's `forky` suite into a folder of its own, for machines that reach Debian's packages only.
# Prints the path of a `godot` that runs with the C library it was built for, beside the system's older one.
# Usage: tools/get_godot_debian.sh FOLDER
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "$0")/common.sh"

[ $# -eq 1 ] || die 2 "usage: tools/get_godot_debian.sh FOLDER"
[ "$(uname -sm)" = "Linux x86_64" ] || die 2 "Debian's packages are for Linux x86_64, not $(uname -sm)"
command -v apt-get dpkg-deb >/dev/null || die 2 "this way to Godot needs apt-get and dpkg-deb"
folder=$1
packages=(godot godot-template-release patchelf libgl1 libegl1 libgl1-mesa-dri)

# The mirror is the one this machine already uses; apt checks the packages' signatures.
mirror() { apt-get indextargets --format '$(REPO_URI) $(RELEASE)' | awk '$2 !~ /security|updates|backports/ {print $1; exit}'; }

# apt gets a world of its own: nothing of the system is read but its keys, nothing is changed.
private_apt() {
	local world=$1
	mkdir -p "$world/parts" "$world/state/lists/partial" "$world/archives/partial"
	: >"$world/status"
	printf 'deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] %s forky main\n' "$(mirror)" >"$world/sources.list"
	cat >"$world/apt.conf" <<-CONF
		Dir::Etc::sourcelist "$world/sources.list";
		Dir::Etc::sourceparts "$world/parts";
		Dir::State "$world/state";
		Dir::State::lists "$world/state/lists";
		Dir::State::status "$world/status";
		Dir::Cache "$world";
		Dir::Cache::archives "$world/archives";
		APT::Install-Recommends "0";
		APT::Sandbox::User "root";
	CONF
	export APT_CONFIG=$world/apt.conf
}

# The unpacked patchelf cannot start by itself on an older system: it goes through the unpacked loader.
patchelf() { "$libraries/ld-linux-x86-64.so.2" --library-path "$libraries:$libraries/pulseaudio" "$root/usr/bin/patchelf" "$@"; }

# Libraries with a run path of their own would look into the system; without it they look beside themselves.
forget_run_paths() {
	local file
	for file in "$libraries"/libpulse*.so* "$libraries"/pulseaudio/*.so "$libraries"/libLLVM.so.*; do
		[ -f "$file" ] && [ ! -L "$file" ] && patchelf --remove-rpath "$file"
	done
	return 0
}

bind_to_libraries() {
	patchelf --set-interpreter "$libraries/ld-linux-x86-64.so.2" --force-rpath \
		--set-rpath "$libraries:$libraries/pulseaudio" "$1"
}

world=$folder.partial/apt
root=$folder/root
libraries=$root/usr/lib/x86_64-linux-gnu

# Downloads survive an interruption in FOLDER.partial; apt verifies and continues them.
private_apt "$world"
say "lab: reading Debian's package lists (forky)"
apt-get -q update >&2
apt-get -q -y --download-only install "${packages[@]}" >&2

rm -rf "$folder" && mkdir -p "$root"
count=$(find "$world/archives" -maxdepth 1 -name '*.deb' | wc -l)
say "lab: unpacking $count packages ($(du -sh "$world/archives" | cut -f1)) into $root"
find "$world/archives" -maxdepth 1 -name '*.deb' -print0 | xargs -0 -I{} dpkg-deb -x {} "$root"
forget_run_paths
mkdir -p "$folder/bin"
cp "$root"/usr/bin/godot "$folder/bin/godot"
bind_to_libraries "$folder/bin/godot"
"$folder/bin/godot" --version >&2
rm -rf "$folder.partial"
echo "$folder/bin/godot"
