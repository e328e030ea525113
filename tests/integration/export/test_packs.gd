extends LabTest
## The real packs of four demos, exported here: the lab, the smallest and a large lesson, and the
## workshop. `./lab needs` does the same with all of them.

const CollectTexts := preload("res://tools/texts/collect_texts.gd")
const CompiledScript := preload("res://tools/export/compiled_script.gd")
const Pack := preload("res://tools/export/pack.gd")
const PackRules := preload("res://tools/export/pack_rules.gd")
const Presets := preload("res://tools/export/presets.gd")
const WrittenCode := preload("res://tools/export/written_code.gd")

const _FOLDER := "res://build/test/packs"
const _DEMOS: PackedStringArray = ["lab", "dot_product", "angled_lines", "workshop"]
const _LESSONS: PackedStringArray = ["dot_product", "angled_lines"]
const _CALLER := """
extends SceneTree
func _init() -> void:
	(load("res://scripts/vec2.gd") as Script).call("unit_radians", 1.0).divided(0.0)
	quit()
"""

const _LANGUAGE := "user://language_in_test.res"

var _packs: Dictionary[String, Pack] = {}


# An export drops missing files from the presets and saves them: put back, so that the test of the
# presets, which runs later, still sees what is committed.
func before_all() -> void:
	var presets := FileAccess.get_file_as_string(Presets.FILE)
	DirAccess.make_dir_recursive_absolute(_FOLDER)
	for demo: String in _DEMOS:
		DirAccess.remove_absolute(_path_of(demo))
		var arguments: PackedStringArray = ["--headless", "--path", _globalized("res://")]
		arguments.append_array(["--export-pack", "linux " + demo, _path_of(demo)])
		OS.execute(OS.get_executable_path(), arguments)
		_packs[demo] = Pack.new(_path_of(demo))
	FileAccess.open(Presets.FILE, FileAccess.WRITE).store_string(presets)


func test_every_pack_keeps_the_rules() -> void:
	for demo: String in _DEMOS:
		assert_eq(PackRules.broken_by(demo, _packs[demo]), PackedStringArray(), demo)


func test_the_dot_product_holds_no_code_of_collisions_worlds_or_reports() -> void:
	assert_has(_packs["dot_product"].sizes, "scripts/vec2.gdc")
	for file: String in _packs["dot_product"].sizes:
		for folder: String in ["scripts/collision/", "scripts/world/", "scripts/report/"]:
			assert_false(file.begins_with(folder), file)


func test_no_pack_holds_or_names_tests_tools_documents_or_the_test_runner() -> void:
	for demo: String in _DEMOS:
		var lists := _list_of_classes(demo)
		for file: String in _packs[demo].sizes:
			lists += "res://%s\n" % file
		for folder: String in ["addons", "tests", "tools", "docs", "benchmarks"]:
			assert_false(lists.contains("res://%s/" % folder), "%s holds %s" % [demo, folder])


func test_no_lesson_holds_a_word_of_the_workshop() -> void:
	var all := CollectTexts.messages()
	var of_workshop := all.keys().filter(
		func(message: String) -> bool: return _is_of_workshop(all[message])
	)
	assert_gt(of_workshop.size(), 200)
	assert_has(_texts_in("dot_product"), "The dot product", "texts are found in a pack")
	for demo: String in _LESSONS:
		for message in _texts_in(demo):
			assert_does_not_have(of_workshop, message, demo)


func test_no_lesson_holds_or_names_the_workshop() -> void:
	for demo: String in _LESSONS:
		for file: String in _packs[demo].sizes:
			assert_false(file.contains("workshop"), "%s holds %s" % [demo, file])
		assert_false(_list_of_classes(demo).contains("workshop"), demo)
		for action: StringName in [&"lab_own_code", &"lab_check_code"]:
			assert_does_not_have(_actions_in(demo), action, demo)
		var settings := _packs[demo].bytes_of("project.binary").hex_encode()
		assert_false(settings.contains("workshop".to_utf8_buffer().hex_encode()), demo)


func test_the_workshop_holds_the_starters_and_no_answer_but_as_a_checksum() -> void:
	var sizes := _packs["workshop"].sizes
	for file: String in WorkshopFiles.CLASSES:
		assert_has(sizes, "workshop/starters/" + file)
	var key := _packs["workshop"].bytes_of("answer_key.txt").get_string_from_utf8().split("\n")
	assert_eq(key, WorkshopAnswerKey.sums())
	assert_gt(key.size(), 10)
	for file: String in sizes:
		assert_false(file.begins_with("scenes/lessons/normals"), file)


func test_the_export_leaves_the_projects_own_list_of_classes_whole() -> void:
	var classes := FileAccess.get_file_as_string("res://.godot/global_script_class_cache.cfg")
	assert_string_contains(classes, "res://tests/support/lab_test.gd")
	assert_string_contains(_list_of_classes("lab"), "res://scripts/world/event/event_world.gd")


func test_a_pack_holds_the_input_actions_of_its_scripts_only() -> void:
	for demo: String in _LESSONS:
		assert_has(_actions_in(demo), &"lab_copy_link", demo)
	assert_has(_actions_in("workshop"), &"lab_check_code")
	assert_has(_actions_in("angled_lines"), &"lab_gravity_left")
	assert_does_not_have(_actions_in("dot_product"), &"lab_gravity_left")


func test_a_compiled_script_names_what_its_text_names() -> void:
	var vec2 := CompiledScript.new(_packs["dot_product"].bytes_of("scripts/vec2.gdc"))
	var written := WrittenCode.names_in(FileAccess.get_file_as_string("res://scripts/vec2.gd"))
	assert_true(vec2.is_valid)
	for word: String in ["Vec2", "scalar_projection", "limit_length", "to_vector2"]:
		assert_has(vec2.names, word)
		assert_has(written, word)


func test_what_is_no_compiled_script_has_no_names() -> void:
	for text: String in ["", "GDSC", "extends RefCounted\nvar no_tokens := 1"]:
		assert_false(CompiledScript.new(text.to_utf8_buffer()).is_valid)


# In a folder without a project: there the engine finds nothing but the pack.
func test_a_pack_alone_starts_without_a_word_of_an_error() -> void:
	for demo: String in _DEMOS:
		var said := []
		var arguments: PackedStringArray = ["--headless", "--path", _globalized(_FOLDER)]
		arguments.append_array(["--main-pack", _path_of(demo), "--quit-after", "3"])
		assert_eq(OS.execute(OS.get_executable_path(), arguments, said, true), 0, demo)
		assert_eq(_first_error(str(said[0])), "", demo)


# Most line numbers are left out of a pack, but not those that an error tells.
func test_an_error_in_a_pack_tells_its_line() -> void:
	var caller := _globalized(_FOLDER.path_join("caller.gd"))
	FileAccess.open(caller, FileAccess.WRITE).store_string(_CALLER)
	var said := []
	var arguments: PackedStringArray = ["--headless", "--path", _globalized(_FOLDER)]
	arguments.append_array(["--main-pack", _path_of("dot_product"), "-s", caller])
	OS.execute(OS.get_executable_path(), arguments, said, true)
	var code := FileAccess.get_file_as_string("res://scripts/vec2.gd")
	var line := code.get_slice('push_error("Vec2.divided', 0).count("\n") + 1
	assert_string_contains(str(said[0]), "divided (res://scripts/vec2.gd:%d)" % line)


func _actions_in(demo: String) -> Array:
	return InputActions.unpacked(_packs[demo].bytes_of("input_actions.bin")).keys()


func _is_of_workshop(places: PackedStringArray) -> bool:
	return Array(places).all(
		func(place: String) -> bool:
			return place.begins_with("workshop/") or place.begins_with("scenes/workshop/")
	)


# In a compiled language each text ends with a zero.
# What the pack of a demo says in Dutch, by what it says in English.
func _texts_in(demo: String) -> PackedStringArray:
	var bytes := _packs[demo].bytes_of("assets/translations/nl.res")
	FileAccess.open(_LANGUAGE, FileAccess.WRITE).store_buffer(bytes)
	var mode := ResourceLoader.CACHE_MODE_IGNORE
	var texts := (ResourceLoader.load(_LANGUAGE, "", mode) as Translation).get_message_list()
	DirAccess.remove_absolute(_LANGUAGE)
	return texts


func _first_error(said: String) -> String:
	for line: String in said.split("\n"):
		if line.contains("ERROR") or line.contains("WARNING"):
			return line
	return ""


func _list_of_classes(demo: String) -> String:
	var bytes := _packs[demo].bytes_of(".godot/global_script_class_cache.cfg")
	return bytes.get_string_from_utf8()


func _path_of(demo: String) -> String:
	return _globalized(_FOLDER.path_join(demo + ".pck"))


func _globalized(path: String) -> String:
	return ProjectSettings.globalize_path(path)
