@tool
extends EditorExportPlugin
## Makes packs smaller, in exports from the editor and from a command line alike.
##
## Godot 4.6 puts into every pack what belongs to the whole project: two files of its cache, with
## the class names and the ids of ALL files, tests included, 100 KB of them, and every input action.
## (Later versions leave the classes and ids out themselves.) While it exports, those files hold
## what the exported files need, the input actions are in one compressed file, and settings that
## only the editor reads are at their defaults; afterwards all are as they were. Scenes and
## resources are compressed, which Godot does with scripts only. Each scene holds the icons that it
## shows: as a file of its own an icon takes 700 bytes, in a compressed scene 140. Compiled scripts
## keep the line numbers that an error tells, and no others. A language has the texts of the files
## that are exported.

const CompiledScript := preload("compiled_script.gd")
const LanguageFile := preload("res://tools/texts/language_file.gd")
const WrittenCode := preload("written_code.gd")

const _CLASSES := "res://.godot/global_script_class_cache.cfg"
const _IDS := "res://.godot/uid_cache.bin"
const _CLASS_ENTRY := (
	'{"base":"{base}","class":"{class}","is_abstract":{is_abstract},"is_tool":{is_tool},'
	+ '"language":"{language}","path":"{path}"}'
)
const _COMPRESSED := "res://.godot/exported/compressed."
const _ACTION := "input/"
const _OWN_ACTIONS := "input/lab_"
# Which plugins the editor has to start.
const _PLUGINS := "editor_plugins/enabled"
# Settings that only the editor reads, or what no pack holds: a pack has them at their defaults,
# which take no room.
const _OF_THE_EDITOR: PackedStringArray = [
	"application/config/description",
	"application/config/features",
	"compression/formats/zstd/compression_level",
	"debug/gdscript/warnings/directory_rules",
	"debug/gdscript/warnings/untyped_declaration",
	"debug/gdscript/warnings/unsafe_property_access",
	"debug/gdscript/warnings/unsafe_method_access",
	"debug/gdscript/warnings/unsafe_cast",
	"debug/gdscript/warnings/unsafe_call_argument",
]
# What the lab alone finds by a setting.
const _OF_THE_LAB: PackedStringArray = [
	"vec2_lab/lesson/besides",
	"vec2_lab/start_screen/besides",
	"application/run/main_scene.workshop",
]
# A pack with this script holds the starters, too, which Godot itself does not look into.
const _READS_STARTERS := "res://workshop/kit/files.gd"

var _files_before: Dictionary[String, PackedByteArray] = {}
var _settings_before: Dictionary[String, Variant] = {}
var _orders_before: Dictionary[String, int] = {}
# Every script of this export as Godot compiles it, by its path in the project.
var _compiled: Dictionary[String, PackedByteArray] = {}
var _is_compiling := false


# Godot takes the plugins in the order of their names, and this one has to come before its own
# “GDScript”, which puts the compiled scripts into the pack.
func _get_name() -> String:
	return "0_lean_packs"


func _export_begin(
	_features: PackedStringArray, is_debug: bool, _path: String, _flags: int
) -> void:
	var preset := get_export_preset()
	if preset.get_export_filter() != EditorExportPreset.EXPORT_SELECTED_RESOURCES:
		return
	_compile(preset, is_debug)
	var files := preset.get_files_to_export()
	for file: String in [_CLASSES, _IDS]:
		_files_before[file] = FileAccess.get_file_as_bytes(file)
	_write(_CLASSES, classes_of(named_as_classes(files), _files_before[_CLASSES]))
	_write(_IDS, ids_of(_named_in_scenes(files), _files_before[_IDS]))
	var left_out := unused_settings(files)
	var actions := actions_in_settings(left_out)
	add_file(InputActions.FILE, packed(actions), false)
	for action: StringName in actions:
		left_out.append(_ACTION + action)
	for setting: String in left_out:
		_settings_before[setting] = ProjectSettings.get_setting(setting)
		_orders_before[setting] = ProjectSettings.get_order(setting)
		ProjectSettings.clear(setting)
	if _READS_STARTERS in files:
		_add_starters()
	var unread := _OF_THE_EDITOR.duplicate()
	for setting: String in _OF_THE_LAB:
		if not _READS_STARTERS in files:
			unread.append(setting)
	for setting: String in unread:
		_settings_before[setting] = ProjectSettings.get_setting(setting)
		_orders_before[setting] = ProjectSettings.get_order(setting)
		ProjectSettings.set_setting(setting, ProjectSettings.property_get_revert(setting))


func _export_end() -> void:
	for file: String in _files_before:
		_write(file, _files_before[file])
	for setting: String in _settings_before:
		ProjectSettings.set_setting(setting, _settings_before[setting])
		ProjectSettings.set_order(setting, _orders_before[setting])
	_files_before.clear()
	_settings_before.clear()
	_compiled.clear()


# The answer key is there as checksums only.
func _add_starters() -> void:
	for file: String in WorkshopFiles.CLASSES:
		var path := WorkshopFiles.STARTERS.path_join(file)
		add_file(path, FileAccess.get_file_as_bytes(path), false)
	var key := "\n".join(WorkshopAnswerKey.sums())
	add_file(WorkshopAnswerKey.PACKED, key.to_utf8_buffer(), false)


# Godot hands compiled scripts out only as files of an export: one that is kept here.
func _compile(preset: EditorExportPreset, is_debug: bool) -> void:
	_is_compiling = true
	get_export_platform().export_project_files(preset, is_debug, _keep_compiled.unbind(5))
	_is_compiling = false


func _keep_compiled(path: String, bytes: PackedByteArray) -> void:
	if path.get_extension() == "gdc":
		_compiled[path.get_basename() + ".gd"] = bytes


func _export_file(path: String, _type: String, _features: PackedStringArray) -> void:
	if _is_compiling:
		return
	if _compiled.has(path):
		skip()
		var lean := CompiledScript.with_fewer_line_numbers(_compiled[path])
		add_file(path.get_basename() + ".gdc", lean, true)
	if _is_icon(path):
		skip()
	if not path.get_extension() in ["tscn", "tres", "po"]:
		return
	var ending := "scn" if path.get_extension() == "tscn" else "res"
	ResourceSaver.save(_lean(path), _COMPRESSED + ending, ResourceSaver.FLAG_COMPRESS)
	var bytes := FileAccess.get_file_as_bytes(_COMPRESSED + ending)
	add_file(path.get_basename() + "." + ending, bytes, true)
	DirAccess.remove_absolute(_COMPRESSED + ending)


# What the pack has of a scene, a resource or a language.
func _lean(path: String) -> Resource:
	if path.get_extension() == "po":
		var shown := get_export_preset().get_files_to_export()
		return language_of(shown, LanguageFile.new(path))
	var resource := ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE)
	if resource is PackedScene:
		make_lean(resource as PackedScene)
	return resource


## Makes the icons that [param scene] shows a part of it, and leaves out the ids of its nodes: by
## them the editor finds a node that has been moved or renamed in another scene.
static func make_lean(scene: PackedScene) -> void:
	var content: Dictionary = scene.get("_bundled")
	var values: Array = content["variants"]
	for place: int in values.size():
		if values[place] is DPITexture:
			var icon: DPITexture = values[place]
			values[place] = icon.duplicate()
	content["node_ids"] = PackedInt32Array()
	content["id_paths"] = []
	scene.set("_bundled", content)


## The texts of a language that one of [param files] shows.
static func language_of(files: PackedStringArray, language: LanguageFile) -> Translation:
	for message: String in language.places.duplicate():
		var shows := func(place: String) -> bool: return "res://" + place in files
		if not Array(language.places[message]).any(shows):
			language.translations.erase(message)
			language.places.erase(message)
	return language.translation()


static func _is_icon(path: String) -> bool:
	return path.get_extension() == "svg" and load(path) is DPITexture


## The entries of [param files] in the list of classes, which is a text: with the keys that the
## engine reads, in the shortest form in which it reads them.
static func classes_of(files: PackedStringArray, list: PackedByteArray) -> PackedByteArray:
	var classes := ConfigFile.new()
	classes.parse(list.get_string_from_utf8())
	var entries: Array = classes.get_value("", "list")
	var texts: PackedStringArray = []
	for entry: Dictionary in entries:
		if entry["path"] in files:
			var text := _CLASS_ENTRY.format(entry)
			texts.append(text.replace(":false", ":0").replace(":true", ":1"))
	return ("list=[%s]\n" % ",".join(texts)).to_utf8_buffer()


## The scripts whose class another script, one of [param files], names. A script that is found only
## by its path needs no entry in the list of classes.
static func named_as_classes(files: PackedStringArray) -> PackedStringArray:
	var paths: Dictionary[String, String] = {}
	for entry: Dictionary in ProjectSettings.get_global_class_list():
		paths[entry["class"]] = entry["path"]
	var named: PackedStringArray = []
	for file: String in files:
		if file.get_extension() == "gd":
			for word: String in WrittenCode.names_in(FileAccess.get_file_as_string(file)):
				if paths.get(word, file) != file:
					named.append(paths[word])
	return named


# The files that a scene or resource among [param files] names, without the icons. Only there an id
# is read: scripts name each other by path or class.
static func _named_in_scenes(files: PackedStringArray) -> PackedStringArray:
	var named: PackedStringArray = []
	for file: String in files:
		if file.get_extension() in ["tscn", "tres"]:
			for dependency: String in ResourceLoader.get_dependencies(file):
				var path := dependency.get_slice("::", dependency.count("::"))
				if not _is_icon(path):
					named.append(path)
	return named


## The entries of [param files] in the list of ids: a count, then an id of 8 bytes, a length of 4
## and a path for each.
static func ids_of(files: PackedStringArray, list: PackedByteArray) -> PackedByteArray:
	var count := 0
	var entries := PackedByteArray()
	var place := 4
	while place < list.size():
		var path_at := place + 12
		var end := path_at + list.decode_u32(place + 8)
		if list.slice(path_at, end).get_string_from_utf8() in files:
			entries.append_array(list.slice(place, end))
			count += 1
		place = end
	var head := PackedByteArray([0, 0, 0, 0])
	head.encode_u32(0, count)
	return head + entries


## The events of each input action in the project's own settings, without the settings
## [param left_out].
static func actions_in_settings(left_out: PackedStringArray) -> Dictionary[StringName, Array]:
	var settings := ConfigFile.new()
	settings.load("res://project.godot")
	var found: Dictionary[StringName, Array] = {}
	for name: String in settings.get_section_keys("input"):
		if not _ACTION + name in left_out:
			var action: Dictionary = settings.get_value("input", name)
			found[StringName(name)] = action["events"]
	return found


## The content of [constant InputActions.FILE] for these actions, each with its events.
static func packed(actions: Dictionary[StringName, Array]) -> PackedByteArray:
	var plain := var_to_bytes_with_objects(actions)
	var size: PackedByteArray = [0, 0, 0, 0]
	size.encode_u32(0, plain.size())
	return size + plain.compress(FileAccess.COMPRESSION_ZSTD)


## The settings that a pack with these files does not need: the project's own input actions that
## none of the scripts in [param files] names, and the list of the editor's plugins.
static func unused_settings(files: PackedStringArray) -> PackedStringArray:
	var named: PackedStringArray = []
	for file: String in files:
		if file.get_extension() == "gd":
			named.append_array(WrittenCode.strings_in(FileAccess.get_file_as_string(file)))
	var unused: PackedStringArray = [_PLUGINS]
	for property: Dictionary in ProjectSettings.get_property_list():
		var setting: String = property["name"]
		if setting.begins_with(_OWN_ACTIONS) and not setting.trim_prefix(_ACTION) in named:
			unused.append(setting)
	return unused


func _write(file: String, bytes: PackedByteArray) -> void:
	FileAccess.open(file, FileAccess.WRITE).store_buffer(bytes)
