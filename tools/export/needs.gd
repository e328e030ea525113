extends SceneTree
## Prints what the pack of each demo holds, a table, and writes the lists into build/needs/. Ends
## with 1 when a pack breaks a rule: see pack_rules.gd.
## Usage: godot --headless --path . -s tools/export/needs.gd -- NAME...
##
## Times of first frames, in milliseconds by the demos' names, are taken from first_frames.json
## beside the exported demos of a platform, where somebody has measured them.

const Demos := preload("demos.gd")
const Pack := preload("pack.gd")
const PackRules := preload("pack_rules.gd")
const PackUse := preload("pack_use.gd")

const _EXPORTED := "res://build/export"
const _LISTS := "res://build/needs"
const _HEADS: PackedStringArray = [
	"demo", "scripts", "scenes", "other", "pack", "of the lab", "first frame: Linux", "web"
]
const _NOT_MEASURED := "not measured"

var _lab_size := 0
var _first_frames: Dictionary[String, Dictionary] = {}
var _rows: Array[PackedStringArray] = [_HEADS]
var _broken: PackedStringArray = []


func _init() -> void:
	DirAccess.make_dir_recursive_absolute(_LISTS)
	for platform: String in ["linux", "web"]:
		_first_frames[platform] = _read_first_frames(platform)
	_lab_size = _pack_of(Demos.LAB).total_size
	for demo: String in OS.get_cmdline_user_args():
		_add(demo, _pack_of(demo))
	_print_table()
	for sentence: String in _broken:
		print("broken " + sentence)
	quit(mini(_broken.size(), 1))


func _pack_of(demo: String) -> Pack:
	var path := _EXPORTED.path_join("linux/%s/%s.pck" % [demo, demo])
	return Pack.new(ProjectSettings.globalize_path(path))


func _read_first_frames(platform: String) -> Dictionary:
	var file := _EXPORTED.path_join(platform).path_join("first_frames.json")
	var read: Variant = JSON.parse_string(FileAccess.get_file_as_string(file))
	return read if read is Dictionary else {}


func _add(demo: String, pack: Pack) -> void:
	_broken.append_array(PackRules.broken_by(demo, pack))
	var use := PackUse.new(pack, Demos.opened_by_engine(demo))
	var counts: Dictionary[String, int] = {}
	for path: String in use.resources:
		counts[path.get_extension()] = counts.get(path.get_extension(), 0) + 1
	var scripts: int = counts.get("gd", 0)
	var scenes: int = counts.get("tscn", 0)
	(
		_rows
		. append(
			PackedStringArray(
				[
					demo,
					str(scripts),
					str(scenes),
					str(use.resources.size() - scripts - scenes),
					"%.1f KB" % (pack.total_size / 1000.0),
					"%.0f %%" % (100.0 * pack.total_size / maxi(_lab_size, 1)),
					_first_frame("linux", demo),
					_first_frame("web", demo),
				]
			)
		)
	)
	_write_list(demo, pack)


func _first_frame(platform: String, demo: String) -> String:
	if not _first_frames[platform].has(demo):
		return _NOT_MEASURED
	var milliseconds: float = _first_frames[platform][demo]
	return "%.0f ms" % milliseconds


func _write_list(demo: String, pack: Pack) -> void:
	var lines: PackedStringArray = []
	for file: String in pack.sizes:
		lines.append("%7d  %s" % [pack.sizes[file], file])
	lines.sort()
	lines.reverse()
	var list := FileAccess.open(_LISTS.path_join(demo + ".txt"), FileAccess.WRITE)
	list.store_string("%d bytes in all\n\n%s\n" % [pack.total_size, "\n".join(lines)])


func _print_table() -> void:
	for row: PackedStringArray in _rows:
		var line := ""
		for column: int in row.size():
			var width := _width(column)
			line += "  " + (row[column].rpad(width) if column == 0 else row[column].lpad(width))
		print("row" + line)


func _width(column: int) -> int:
	var width := 0
	for row: PackedStringArray in _rows:
		width = maxi(width, row[column].length())
	return width
