extends RefCounted
## The export presets: one for each demo on each platform, with the list of the files that it
## holds. They win over what is chosen in the editor's export window.

const Demos := preload("demos.gd")
const PresetOptions := preload("preset_options.gd")

const FILE := "res://export_presets.cfg"
## What brings a stale [constant FILE] up to date.
const COMMAND := "./lab export presets"

const _COMPRESSED_TOKENS := 2

const _PLATFORMS: Dictionary[String, String] = {"linux": "Linux", "web": "Web"}
const _EXPORTED_FILE: Dictionary[String, String] = {
	"linux": "build/export/linux/%s/%s.x86_64", "web": "build/export/web/%s/index.html"
}


## The platforms by the names that `./lab export` knows.
static func platforms() -> PackedStringArray:
	return PackedStringArray(_PLATFORMS.keys())


## The name of a preset.
static func name_of(platform: String, demo: String) -> String:
	return "%s %s" % [platform, demo]


## All presets as they have to be now.
static func wanted() -> ConfigFile:
	var presets := ConfigFile.new()
	var number := 0
	for demo: String in Demos.names():
		var files := Demos.needed_by(demo).files
		for platform: String in platforms():
			_add(presets, "preset.%d" % number, platform, demo, files)
			number += 1
	return presets


## What is wrong with the presets in [param file], or "": the editor may have added options.
static func staleness(file: String = FILE) -> String:
	var present := ConfigFile.new()
	if FileAccess.file_exists(file):
		present.load(file)
	var right := wanted()
	for section: String in right.get_sections():
		for key: String in right.get_section_keys(section):
			if not _is_same(present, right, section, key):
				return _stale("“%s” is no longer right in [%s]" % [key, section])
	if present.get_sections().size() != right.get_sections().size():
		return _stale("it holds presets that no demo has")
	return ""


static func _is_same(a: ConfigFile, b: ConfigFile, section: String, key: String) -> bool:
	return (
		a.has_section_key(section, key) and a.get_value(section, key) == b.get_value(section, key)
	)


static func _stale(reason: String) -> String:
	return "%s is stale (%s): run %s" % [FILE.get_file(), reason, COMMAND]


static func _add(
	presets: ConfigFile, section: String, platform: String, demo: String, files: PackedStringArray
) -> void:
	var entries := {
		"name": name_of(platform, demo),
		"platform": _PLATFORMS[platform],
		"runnable": demo == Demos.LAB,
		"dedicated_server": false,
		"custom_features": Demos.feature_of(demo),
		"export_filter": "resources",
		"export_files": files,
		"include_filter": "",
		"exclude_filter": "",
		"export_path": _EXPORTED_FILE[platform].replace("%s", demo),
	}
	entries.merge(PresetOptions.PACKING)
	entries["script_export_mode"] = _COMPRESSED_TOKENS
	for key: String in entries:
		presets.set_value(section, key, entries[key])
	var options := PresetOptions.OF_PLATFORM[platform]
	for option: String in options:
		presets.set_value(section + ".options", option, options[option])
