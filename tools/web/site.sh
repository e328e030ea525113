# shellcheck shell=bash
# The exported web site: where it is, and whether it is as the project is now. Sourced after common.sh.

site=$LAB_BUILD/export/web

is_site_up_to_date() {
	[ -f "$site/index.html" ] || return 1
	local newer
	newer=$(cd "$LAB_ROOT" && find scripts scenes assets workshop/kit workshop/starters tools/web docs/teaching.md project.godot export_presets.cfg \
		-newer "$site/index.html" -print 2>/dev/null)
	[ -z "$newer" ]
}

# The project as it is now, for the browser.
bring_site_up_to_date() { is_site_up_to_date || "$LAB_ROOT/lab" export web; }
