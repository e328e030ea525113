extends LabTest
## The icons on buttons.

const _FOLDER := "res://assets/icons/"
# The window's; no button shows it.
const _APP_ICON := "app_icon.svg"


func test_every_icon_is_drawn_anew_for_each_scale_of_the_window() -> void:
	for file: String in ResourceLoader.list_directory(_FOLDER):
		if file != _APP_ICON:
			assert_true(load(_FOLDER + file) is DPITexture, file)
