extends LabTest
## Packs that break the rules for exports, each in its way.

const Pack := preload("res://tools/export/pack.gd")
const PackRules := preload("res://tools/export/pack_rules.gd")

const _FILE := "user://breaking.pck"


func after_each() -> void:
	DirAccess.remove_absolute(_FILE)


func test_a_script_that_nothing_uses_is_found() -> void:
	var broken := _broken_by("angled_lines", MadePack.script("scripts/world/event/event_world.gd"))
	assert_string_contains(
		broken, "angled_lines holds scripts/world/event/event_world.gdc, which nothing"
	)


func test_code_of_collisions_in_the_dot_product_is_found() -> void:
	for path: String in [
		"scripts/collision/impact.gd",
		"scripts/world/event/event_world.gd",
		"scripts/report/cases/shot.gd"
	]:
		var sentence := "dot_product holds res://%s: it has no business there" % path
		assert_string_contains(_broken_by("dot_product", MadePack.script(path)), sentence)


func test_the_workshop_is_found_in_a_lesson_and_has_its_place_in_the_lab() -> void:
	for path: String in ["workshop/kit/a.gd", "scenes/workshop/a.gd"]:
		var sentence := "angled_lines holds res://%s: it has no business there" % path
		assert_string_contains(_broken_by("angled_lines", MadePack.script(path)), sentence)
		assert_false(_broken_by("lab", MadePack.script(path)).contains("no business"))


func test_tests_tools_and_the_test_runner_are_found_in_any_pack() -> void:
	for path: String in ["tests/a.gd", "tools/a.gd", "docs/a.gd", "addons/gut/gut.gd"]:
		var sentence := "lab holds res://%s: it has no business there" % path
		assert_string_contains(_broken_by("lab", MadePack.script(path)), sentence)


func test_the_class_of_a_script_that_was_left_out_is_found() -> void:
	var list := 'list=[{"class": &"LabTest", "path": "res://tests/support/lab_test.gd"}]'
	var broken := _broken_by("lab", {".godot/global_script_class_cache.cfg": list})
	assert_string_contains(broken, "lab lists the class of res://tests/support/lab_test.gd")


func test_a_pack_that_is_too_large_is_found() -> void:
	var large := "x".repeat(PackRules.VECTOR_LESSON_LIMIT)
	assert_string_contains(_broken_by("dot_product", {"project.binary": large}), "more than 230000")
	assert_eq(_broken_by("angled_lines", {"project.binary": large}), "")


func test_a_file_that_is_no_pack_breaks_them() -> void:
	assert_string_contains(
		"\n".join(PackRules.broken_by("lab", Pack.new(_FILE))), "cannot be opened"
	)


func _broken_by(demo: String, texts: Dictionary[String, String]) -> String:
	MadePack.write(_FILE, texts)
	return "\n".join(PackRules.broken_by(demo, Pack.new(_FILE)))
