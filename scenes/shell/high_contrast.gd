class_name HighContrast
extends RefCounted
## The lab in stronger colors, as the student has chosen: those of the [Palette], and of the theme,
## which is painted from it.

const _KEY := "high_contrast"
## Borders have this many pixels then.
const _BORDER := 2

# What the theme has in the usual colors, to go back to: for each item of it and each box its
# colors.
static var _usual_colors: Dictionary[PackedStringArray, Color] = {}
static var _usual_boxes: Dictionary[StyleBoxFlat, Array] = {}


## Whether stronger colors are chosen.
static func is_chosen() -> bool:
	return KeptChoices.value(_KEY, false)


## Chooses; it is kept for the next time.
static func choose(wanted: bool) -> void:
	KeptChoices.keep(_KEY, wanted)
	show_chosen()


## Shows everything as it was chosen.
static func show_chosen() -> void:
	var wanted := is_chosen()
	if wanted == Palette.is_high_contrast:
		return
	Palette.is_high_contrast = wanted
	RenderingServer.set_default_clear_color(Palette.drawn(Palette.PANEL))
	_paint(ThemeDB.get_project_theme())
	_draw_again((Engine.get_main_loop() as SceneTree).root)


static func _paint(theme: Theme) -> void:
	for type in theme.get_color_type_list():
		for item in theme.get_color_list(type):
			var key: PackedStringArray = [item, type]
			var usual: Color = _usual_colors.get_or_add(key, theme.get_color(item, type))
			theme.set_color(item, type, Palette.drawn(usual))
	for type in theme.get_stylebox_type_list():
		for item in theme.get_stylebox_list(type):
			var box := theme.get_stylebox(item, type) as StyleBoxFlat
			if box:
				_paint_box(box)


static func _paint_box(box: StyleBoxFlat) -> void:
	var usual: Array = _usual_boxes.get_or_add(
		box, [box.bg_color, box.border_color, box.border_width_top]
	)
	var ground: Color = usual[0]
	var border: Color = usual[1]
	var width: int = usual[2]
	box.bg_color = Palette.drawn(ground)
	box.border_color = Palette.drawn(border)
	if width > 0:
		box.set_border_width_all(maxi(width, _BORDER) if Palette.is_high_contrast else width)


static func _draw_again(node: Node) -> void:
	if node is CanvasItem:
		(node as CanvasItem).queue_redraw()
	for child in node.get_children(true):
		_draw_again(child)
