# shellcheck shell=bash
# A fresh copy of the project, and the real editor on it. Sourced after common.sh.

# A space and an accent, as in many home folders.
copy="$LAB_BUILD/editor check é"

# The files of the project, without those that git ignores.
own_files() {
	cd "$LAB_ROOT" || return
	git ls-files --cached --others --exclude-standard -z | while IFS= read -r -d '' file; do
		[ ! -e "$file" ] || printf '%s\0' "$file"
	done
}

in_copy() { git -C "$copy" -c user.name=check -c user.email=check@localhost "$@"; }

# As a ZIP of the project is unpacked.
make_copy() {
	rm -rf "$copy" "$LAB_BUILD/editor_home"
	mkdir -p "$copy"
	own_files | tar -c -C "$LAB_ROOT" --null -T - | tar -x -C "$copy"
}

# What is changed from now on is seen by `in_copy status`.
remember_copy() {
	in_copy init -q
	in_copy add -A
	in_copy commit -q -m "as it was"
}

# Begins a command, for settings of the editor that nobody has changed.
at_home=(env)
for base in CONFIG DATA CACHE; do
	at_home+=("XDG_${base}_HOME=$LAB_BUILD/editor_home")
done

# said_by_editor LOG: its errors and warnings. Without a graphics card it tries Vulkan before OpenGL, and says so.
said_by_editor() {
	messages_of_editor "$1" | grep -v -e 'VK_KHR_surface' -e 'Condition "err != OK" is true' || true
}
