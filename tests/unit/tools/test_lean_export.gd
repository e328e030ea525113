extends LabTest
## What the export plugin leaves of what the engine puts into every pack.

const Demos := preload("res://tools/export/demos.gd")
const LeanExport := preload("res://tools/export/lean_export.gd")

const _SCENE_WITH_ICONS := "res://scenes/widgets/services/steps.tscn"
const _INHERITED_SCENE := "res://scenes/lessons/l10_line_ends/capped_field.tscn"
const _SAVED := "user://lean.scn"
const _KEPT: PackedStringArray = ["res://kept.gd"]


func test_of_the_classes_those_of_exported_files_stay() -> void:
	var kept := {"base": &"Node", "class": &"Kept", "is_abstract": false, "is_tool": true}
	kept.merge({"language": &"GDScript", "path": "res://kept.gd"})
	var gone := kept.merged({"class": &"Gone", "path": "res://gone.gd"}, true)
	var with_icon := kept.merged({"icon": ""})
	var list := "list=" + var_to_str([with_icon, gone])
	var lean := LeanExport.classes_of(_KEPT, list.to_utf8_buffer()).get_string_from_utf8()
	var entry := '"base":"Node","class":"Kept","is_abstract":0,"is_tool":1,"language":"GDScript"'
	assert_eq(lean, 'list=[{%s,"path":"res://kept.gd"}]\n' % entry)


func test_a_class_that_only_scenes_or_its_own_script_name_is_not_listed() -> void:
	var frame := "res://scenes/shell/lesson_frame.gd"
	var listed := LeanExport.named_as_classes([frame, "res://scripts/vec2.gd"])
	assert_has(listed, "res://scenes/shell/input_help.gd")
	assert_does_not_have(listed, frame)
	assert_does_not_have(listed, "res://scripts/vec2.gd")


func test_a_scene_without_the_ids_of_its_nodes_has_all_of_its_nodes() -> void:
	var mode := ResourceLoader.CACHE_MODE_IGNORE
	var scene: PackedScene = ResourceLoader.load(_INHERITED_SCENE, "", mode)
	var whole: Node = autofree(scene.instantiate())
	LeanExport.make_lean(scene)
	var content: Dictionary = scene.get("_bundled")
	var ids: PackedInt32Array = content["node_ids"]
	assert_eq(ids.size(), 0)
	var lean: Node = autofree(scene.instantiate())
	assert_eq(_paths_below(lean), _paths_below(whole))


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


func test_a_scene_takes_in_its_icons_but_not_its_script() -> void:
	var mode := ResourceLoader.CACHE_MODE_IGNORE
	var scene: PackedScene = ResourceLoader.load(_SCENE_WITH_ICONS, "", mode)
	LeanExport.make_lean(scene)
	ResourceSaver.save(scene, _SAVED)
	var named := ",".join(ResourceLoader.get_dependencies(_SAVED))
	assert_string_contains(named, "steps.gd")
	assert_false(named.contains(".svg"), named)
	var saved: PackedScene = ResourceLoader.load(_SAVED, "", mode)
	DirAccess.remove_absolute(_SAVED)
	var steps: Node = autofree(saved.instantiate())
	assert_true((steps.get_node("%Back") as Button).icon is DPITexture)


func test_an_action_that_no_script_names_is_unused() -> void:
	var unused := LeanExport.unused_settings(["res://scenes/widgets/services/steps.gd"])
	assert_does_not_have(unused, "input/lab_next_step")
	assert_has(unused, "input/lab_pause")
	assert_does_not_have(unused, "input/ui_accept")


func test_the_whole_lab_uses_every_action_and_no_plugin() -> void:
	var unused := LeanExport.unused_settings(Demos.needed_by(Demos.LAB).files)
	assert_eq(unused, PackedStringArray(["editor_plugins/enabled"]))


func _paths_below(node: Node) -> Array:
	return node.find_children("*", "", true, false).map(node.get_path_to)


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
