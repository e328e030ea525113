#!/usr/bin/env bash
# Brings Godot from Debian's `forky` suite into a folder of its own, for machines that reach Debian's packages only.
# Prints the path of a `godot` that runs with the C library it was built for, beside the system's older one; beside
# that lies `godot-template-release`, which does so, too.
# Usage: tools/get/get_godot_debian.sh FOLDER
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../shared/common.sh
. "$(dirname "$0")/../shared/common.sh"

[ $# -eq 1 ] || die 2 "usage: tools/get/get_godot_debian.sh FOLDER"
[ "$(uname -sm)" = "Linux x86_64" ] || die 2 "Debian's packages are for Linux x86_64, not $(uname -sm)"
for tool in apt-get dpkg-deb flock; do
	command -v "$tool" >/dev/null || die 2 "this way to Godot needs $tool"
done
folder=$1
world=$folder.partial/apt
root=$folder/root
libraries=$root/usr/lib/x86_64-linux-gnu
program=$folder/bin/godot
packages=(godot godot-template-release patchelf libgl1 libegl1 libgl1-mesa-dri)

# The mirror is the one this machine already uses; apt checks the packages' signatures.
mirror() {
	apt-get indextargets --format "\$(REPO_URI) \$(RELEASE)" |
		awk '$2 !~ /security|updates|backports/ && !found {print $1; found = 1}'
}

# apt gets a world of its own: nothing of the system is read but its keys, nothing is changed.
private_apt() {
	local address
	address=$(mirror)
	if [ -z "$address" ] && [ "$(id -u)" -eq 0 ]; then
		say "reading the system's package lists, to learn its mirror"
		apt-get -q update >&2
		address=$(mirror)
	fi
	[ -n "$address" ] || die 1 "apt knows no mirror yet; run 'apt-get update' as root first"
	mkdir -p "$world/parts" "$world/state/lists/partial" "$world/archives/partial"
	: >"$world/status"
	printf 'deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] %s forky main\n' "$address" >"$world/sources.list"
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

# Downloads survive an interruption in FOLDER.partial; apt verifies and continues them.
download() {
	say "reading Debian's package lists (forky)"
	apt-get -q update >&2
	say "downloading Godot $GODOT_VERSION and what it stands on from Debian"
	apt-get -q -y --download-only install "${packages[@]}" >&2
}

unpack() {
	local archives=("$world"/archives/*.deb) archive
	say "unpacking ${#archives[@]} packages ($(du -sh "$world/archives" | cut -f1)) into $root"
	for archive in "${archives[@]}"; do
		dpkg-deb -x "$archive" "$root"
	done
}

# The unpacked patchelf cannot start by itself on an older system: it goes through the unpacked loader.
patchelf() { "$libraries/ld-linux-x86-64.so.2" --library-path "$libraries:$libraries/pulseaudio" "$root/usr/bin/patchelf" "$@"; }

# Libraries with a run path of their own would look into the system; without it they look beside themselves.
forget_run_paths() {
	local file
	for file in "$libraries"/libpulse*.so* "$libraries"/pulseaudio/*.so "$libraries"/libLLVM.so.*; do
		if [ -f "$file" ] && [ ! -L "$file" ]; then
			patchelf --remove-rpath "$file"
		fi
	done
}

bind_to_libraries() {
	patchelf --set-interpreter "$libraries/ld-linux-x86-64.so.2" --force-rpath \
		--set-rpath "$libraries:$libraries/pulseaudio" "$1"
}

# install NAME: a program gets its name last, so an interrupted run never leaves half of one that counts as whole.
install() {
	mkdir -p "$folder/bin"
	cp "$root/usr/bin/$1" "$folder/bin/$1.partial"
	bind_to_libraries "$folder/bin/$1.partial"
	"$folder/bin/$1.partial" --version >/dev/null
	mv "$folder/bin/$1.partial" "$folder/bin/$1"
}

mkdir -p "$(dirname "$folder")"
exec 9>"$folder.lock"
flock 9
if [ ! -x "$program" ]; then
	private_apt
	download
	rm -rf "$folder"
	mkdir -p "$root"
	unpack
	forget_run_paths
	install godot
	rm -rf "$folder.partial"
fi
[ -x "$folder/bin/godot-template-release" ] || install godot-template-release
echo "$program"
