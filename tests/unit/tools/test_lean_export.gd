extends LabTest
## What the export plugin leaves of what the engine puts into every pack.

const Demos := preload("res://tools/export/demos.gd")
const LeanExport := preload("res://tools/export/lean_export.gd")

const _KEPT: PackedStringArray = ["res://kept.gd"]


func test_of_the_classes_those_of_exported_files_stay() -> void:
	var kept := {"base": &"Node", "class": &"Kept", "is_abstract": false, "is_tool": true}
	kept.merge({"language": &"GDScript", "path": "res://kept.gd"})
	var gone := kept.merged({"class": &"Gone", "path": "res://gone.gd"}, true)
	var with_icon := kept.merged({"icon": ""})
	var list := "list=" + var_to_str([with_icon, gone])
	var lean := ConfigFile.new()
	lean.parse(LeanExport.classes_of(_KEPT, list.to_utf8_buffer()).get_string_from_utf8())
	var entries: Array = lean.get_value("", "list")
	# The engine brings each value to the kind that it needs.
	var wanted := {"base": "Node", "class": "Kept", "is_abstract": 0, "is_tool": 1}
	wanted.merge({"language": "GDScript", "path": "res://kept.gd"})
	assert_eq(entries, [wanted])


func test_of_the_ids_those_of_exported_files_stay() -> void:
	var kept := _entry(7, "res://kept.gd")
	var list := _count(3) + _entry(5, "res://gone.gd") + kept + _entry(9, "res://last.gd")
	assert_eq(LeanExport.ids_of(_KEPT, list), _count(1) + kept)


func test_an_empty_list_of_ids_stays_empty() -> void:
	assert_eq(LeanExport.ids_of(_KEPT, PackedByteArray()), _count(0))


func test_the_lists_of_this_project_are_read_as_the_engine_writes_them() -> void:
	var ids := LeanExport.ids_of(
		["res://scripts/vec2.gd"], FileAccess.get_file_as_bytes("res://.godot/uid_cache.bin")
	)
	var id := ids.decode_s64(4)
	assert_eq(ResourceUID.get_id_path(id), "res://scripts/vec2.gd")


func test_an_action_that_no_script_but_the_list_of_their_words_names_is_unused() -> void:
	var unused := LeanExport.unused_settings(
		["res://scenes/shell/input_help.gd", "res://scenes/widgets/services/steps.gd"]
	)
	assert_does_not_have(unused, "input/lab_next_step")
	assert_has(unused, "input/lab_pause")
	assert_does_not_have(unused, "input/ui_accept")


func test_the_whole_lab_uses_every_action_but_no_plugin_of_the_editor() -> void:
	var unused := LeanExport.unused_settings(Demos.needed_by(Demos.LAB).files)
	assert_eq(unused, PackedStringArray(["editor_plugins/enabled"]))


func _count(count: int) -> PackedByteArray:
	var bytes := PackedByteArray([0, 0, 0, 0])
	bytes.encode_u32(0, count)
	return bytes


func _entry(id: int, path: String) -> PackedByteArray:
	var bytes := PackedByteArray()
	bytes.resize(12)
	bytes.encode_s64(0, id)
	bytes.encode_u32(8, path.length())
	return bytes + path.to_utf8_buffer()
