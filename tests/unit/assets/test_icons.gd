extends LabTest
## The icons on buttons.

const Demos := preload("res://tools/export/demos.gd")
const WrittenCode := preload("res://tools/export/written_code.gd")
const _FOLDER := "res://assets/icons/"
# The window's; no button shows it.
const _APP_ICON := "app_icon.svg"


func test_every_icon_is_drawn_anew_for_each_scale_of_the_window() -> void:
	for file: String in ResourceLoader.list_directory(_FOLDER):
		if file != _APP_ICON:
			assert_true(load(_FOLDER + file) is DPITexture, file)


func test_scripts_get_their_icons_from_scenes_because_a_pack_holds_them_only_there() -> void:
	for file: String in Demos.needed_by(Demos.LAB).files:
		if file.get_extension() == "gd":
			for string: String in WrittenCode.strings_in(FileAccess.get_file_as_string(file)):
				assert_false(string.begins_with(_FOLDER), "%s names %s" % [file, string])
