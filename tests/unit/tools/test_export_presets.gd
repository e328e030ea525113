extends LabTest
## The committed export presets against what each demo needs now.

const Demos := preload("res://tools/export/demos.gd")
const Presets := preload("res://tools/export/presets.gd")

const _CHANGED := "user://changed_presets.cfg"


func after_each() -> void:
	DirAccess.remove_absolute(_CHANGED)


func test_the_committed_presets_are_up_to_date() -> void:
	assert_eq(Presets.staleness(), "")


func test_there_is_a_preset_for_each_demo_on_each_platform() -> void:
	var names: PackedStringArray = []
	var presets := _committed()
	for section: String in presets.get_sections():
		names.append(str(presets.get_value(section, "name", "")))
	for demo: String in Demos.names():
		for platform: String in ["linux", "web"]:
			assert_has(names, "%s %s" % [platform, demo])


func test_a_missing_file_makes_them_stale_and_the_command_is_named() -> void:
	var presets := _committed()
	var files: PackedStringArray = presets.get_value("preset.0", "export_files")
	presets.set_value("preset.0", "export_files", files.slice(1))
	_assert_stale(presets, "export_files")


func test_a_preset_too_many_makes_them_stale() -> void:
	var presets := _committed()
	presets.set_value("preset.99", "name", "linux no_lesson")
	_assert_stale(presets, "no demo has")


func test_an_option_that_the_editor_has_added_does_not() -> void:
	var presets := _committed()
	presets.set_value("preset.0", "new_in_the_next_godot", 0)
	presets.save(_CHANGED)
	assert_eq(Presets.staleness(_CHANGED), "")


func _committed() -> ConfigFile:
	var presets := ConfigFile.new()
	presets.load(Presets.FILE)
	return presets


func _assert_stale(presets: ConfigFile, reason: String) -> void:
	presets.save(_CHANGED)
	var sentence := Presets.staleness(_CHANGED)
	assert_string_contains(sentence, reason)
	assert_string_ends_with(sentence, "run ./lab export presets")
