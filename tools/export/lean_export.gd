@tool
extends EditorExportPlugin
## Makes packs smaller, in exports from the editor and from a command line alike.
##
## Godot 4.6 copies two files of its cache into every pack: the class names and the ids of ALL files
## of the project, tests included, 100 KB of them. (Later versions copy what belongs to the exported
## files.) While it exports, they hold the entries of the exported files only; afterwards they are
## as they were. Scenes and resources are compressed, which Godot does with scripts only.

const _CLASSES := "res://.godot/global_script_class_cache.cfg"
const _IDS := "res://.godot/uid_cache.bin"
const _COMPRESSED := "res://.godot/exported/compressed."

var _before: Dictionary[String, PackedByteArray] = {}


func _get_name() -> String:
	return "lean_packs"


func _export_begin(
	_features: PackedStringArray, _is_debug: bool, _path: String, _flags: int
) -> void:
	var preset := get_export_preset()
	if preset.get_export_filter() != EditorExportPreset.EXPORT_SELECTED_RESOURCES:
		return
	var files := preset.get_files_to_export()
	for file: String in [_CLASSES, _IDS]:
		_before[file] = FileAccess.get_file_as_bytes(file)
	_write(_CLASSES, classes_of(files, _before[_CLASSES]))
	_write(_IDS, ids_of(files, _before[_IDS]))


func _export_end() -> void:
	for file: String in _before:
		_write(file, _before[file])
	_before.clear()


func _export_file(path: String, _type: String, _features: PackedStringArray) -> void:
	if not path.get_extension() in ["tscn", "tres"]:
		return
	var ending := "scn" if path.get_extension() == "tscn" else "res"
	var resource := ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE)
	ResourceSaver.save(resource, _COMPRESSED + ending, ResourceSaver.FLAG_COMPRESS)
	var bytes := FileAccess.get_file_as_bytes(_COMPRESSED + ending)
	add_file(path.get_basename() + "." + ending, bytes, true)
	DirAccess.remove_absolute(_COMPRESSED + ending)


## The entries of [param files] in the list of classes, which is a text.
static func classes_of(files: PackedStringArray, list: PackedByteArray) -> PackedByteArray:
	var classes := ConfigFile.new()
	classes.parse(list.get_string_from_utf8())
	var entries: Array = classes.get_value("", "list")
	classes.set_value(
		"", "list", entries.filter(func(entry: Dictionary) -> bool: return entry["path"] in files)
	)
	return classes.encode_to_text().to_utf8_buffer()


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


func _write(file: String, bytes: PackedByteArray) -> void:
	FileAccess.open(file, FileAccess.WRITE).store_buffer(bytes)
