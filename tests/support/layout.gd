class_name Layout
## What is wrong with how a screen is laid out: overlaps, parts cut off, texts that do not fit.
##
## The board is left out: things lie on top of each other there on purpose.

## Differences up to this many pixels come from rounding.
const _TOLERANCE := 1.0


## One sentence for each thing that is wrong; what lies on a board or below the fold of something
## that scrolls is not looked at.
static func problems(screen: Control) -> PackedStringArray:
	var found: PackedStringArray = []
	var view := Rect2(Vector2.ZERO, screen.get_viewport_rect().size)
	if not _holds(view, screen.get_global_rect()):
		found.append("the screen is %s in a view of %s" % [screen.size, view.size])
	for control: Control in Screen.controls(screen):
		if not _lies_on_board(control):
			found.append_array(_overlaps(control))
			found.append_array(_cut_off_parts(control))
			found.append_array(_text_that_does_not_fit(control))
	return found


static func _overlaps(above: Control) -> PackedStringArray:
	var found: PackedStringArray = []
	if above is not Container:
		return found
	var parts := _visible_parts(above)
	for i: int in parts.size():
		for j: int in i:
			var common := parts[i].get_rect().intersection(parts[j].get_rect())
			if minf(common.size.x, common.size.y) > _TOLERANCE:
				found.append("%s lies on %s" % [_title(parts[i]), _title(parts[j])])
	return found


static func _cut_off_parts(above: Control) -> PackedStringArray:
	var found: PackedStringArray = []
	var room := above.get_global_rect()
	if above is ScrollContainer:
		room = room.grow_individual(0.0, 1e6, 0.0, 1e6)
	for part: Control in _visible_parts(above):
		if not _holds(room, part.get_global_rect()):
			found.append("%s goes beyond %s" % [_title(part), _title(above)])
	return found


static func _text_that_does_not_fit(control: Control) -> PackedStringArray:
	var label := control as Label
	if not label or label.text_overrun_behavior == TextServer.OVERRUN_NO_TRIMMING:
		return []
	var font := label.get_theme_font(&"font")
	var font_size := label.get_theme_font_size(&"font_size")
	var text := Screen.text_of(label)
	var width := font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size).x
	return [] if width <= label.size.x + _TOLERANCE else ["“%s” is cut short" % text]


static func _visible_parts(above: Control) -> Array[Control]:
	var parts: Array[Control] = []
	for child: Node in above.get_children():
		if child is Control and (child as Control).visible and not _lies_on_board(child as Control):
			parts.append(child as Control)
	return parts


static func _lies_on_board(control: Control) -> bool:
	return control.get_parent() is Board or control.get_parent() is Node2D


static func _holds(room: Rect2, part: Rect2) -> bool:
	return room.grow(_TOLERANCE).encloses(part)


static func _title(control: Control) -> String:
	var text := Screen.text_of(control)
	return "“%s”" % text if text else str(control.name)
