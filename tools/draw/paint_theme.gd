extends SceneTree
## Writes the colors of the palette into the theme's file.
## Usage: godot --headless --path . -s tools/draw/paint_theme.gd

const ThemeColors := preload("theme_colors.gd")


func _init() -> void:
	var text := ThemeColors.painted(FileAccess.get_file_as_string(ThemeColors.FILE))
	FileAccess.open(ThemeColors.FILE, FileAccess.WRITE).store_string(text)
	quit()
