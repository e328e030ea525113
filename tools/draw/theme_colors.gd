extends RefCounted
## The colors of assets/theme.tres: which part has which color of the [Palette]. The editor needs
## the numbers in the file, so they are written there from here; a test says when they are stale.

const FILE := "res://assets/theme.tres"

const _INK := Palette.Role.INK

# What differs from the usual: text is ink, a box is a field with a border.
static var _special: Dictionary[String, Color] = {
	"bar_fill.bg_color": Palette.FOCUS,
	"button_hover.bg_color": Palette.PAPER,
	"button_hover.border_color": Palette.color(_INK),
	"button_pressed.bg_color": Palette.GRID,
	"button_pressed.border_color": Palette.color(_INK),
	"button_disabled.bg_color": Palette.PANEL,
	"button_disabled.border_color": Palette.GRID,
	"small_button_hover.bg_color": Palette.PAPER,
	"small_button_hover.border_color": Palette.color(_INK),
	"small_button_pressed.bg_color": Palette.GRID,
	"small_button_pressed.border_color": Palette.color(_INK),
	"focus.bg_color": Color(Palette.FIELD, 0.0),
	"focus.border_color": Palette.FOCUS,
	"fold.bg_color": Palette.PAPER,
	"notice.border_color": Palette.color(Palette.Role.WRONG),
	"menu_hover.bg_color": Palette.PANEL,
	"tooltip.bg_color": Palette.color(_INK),
	"Button/colors/font_disabled_color": Palette.color(Palette.Role.QUIET),
	"Button/colors/icon_disabled_color": Color(Palette.color(Palette.Role.QUIET), 0.5),
	"CheckButton/colors/button_checked_color": Palette.FOCUS,
	"CheckButton/colors/button_unchecked_color": Palette.color(Palette.Role.QUIET),
	"LabelOnColor/colors/font_color": Palette.FIELD,
	"LabelQuiet/colors/font_color": Palette.color(Palette.Role.QUIET),
	"LineEdit/colors/font_placeholder_color": Palette.color(Palette.Role.QUIET),
	"LineEdit/colors/selection_color": Color(Palette.FOCUS, 0.3),
	"TooltipLabel/colors/font_color": Palette.PAPER,
}


## [param theme], the text of the file, with the colors of the palette.
static func painted(theme: String) -> String:
	var section := RegEx.create_from_string('^\\[sub_resource .*id="(\\w+)"')
	var color := RegEx.create_from_string("^(\\S+) = Color\\(")
	var lines: PackedStringArray = []
	var box := ""
	for line: String in theme.split("\n"):
		var begun := section.search(line)
		if begun:
			box = begun.get_string(1) + "."
		elif line.begins_with("[resource]"):
			box = ""
		var found := color.search(line)
		if found:
			var part := found.get_string(1)
			line = "%s = %s" % [part, var_to_str(_color_of(box + part))]
		lines.append(line)
	return "\n".join(lines)


static func _color_of(part: String) -> Color:
	if part.ends_with(".bg_color"):
		return _special.get(part, Palette.FIELD)
	if part.ends_with(".border_color"):
		return _special.get(part, Palette.BORDER)
	return _special.get(part, Palette.color(_INK))
