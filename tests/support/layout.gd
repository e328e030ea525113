class_name Layout
## What is wrong with how a screen is laid out: overlaps, parts cut off, texts that do not fit.
##
## The board is left out: things lie on top of each other there on purpose. Its texts are looked at
## by [BoardTexts].

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


## The cards on a board that lie on each other or go beyond it.
static func card_problems(board: Control) -> PackedStringArray:
	var found: PackedStringArray = []
	var room := Rect2(Vector2.ZERO, board.size)
	var all := cards(board)
	for i: int in all.size():
		if not _holds(room, all[i].get_rect()):
			found.append("%s goes beyond the board" % all[i].name)
		for j: int in i:
			var common := all[i].get_rect().intersection(all[j].get_rect())
			if minf(common.size.x, common.size.y) > _TOLERANCE:
				found.append("%s lies on %s" % [all[i].name, all[j].name])
	return found


## The cards on a board that can be seen: its own Controls, apart from handles and from boards
## inside it.
static func cards(board: Control) -> Array[Control]:
	var found: Array[Control] = []
	for child: Node in board.get_children():
		var is_card := child is Control and child is not Handle and child is not Board
		if is_card and (child as Control).visible:
			found.append(child as Control)
	return found


## Whether a part can be pressed, dragged or typed into.
static func is_target(control: Control) -> bool:
	if control is BaseButton:
		return not (control as BaseButton).disabled
	return (
		control is LineEdit
		or control is Handle and control is not ArrowBody
		or control is FoldableContainer and (control as FoldableContainer).folded
	)


## The size of the text in a part, in pixels of the drawing; 0 for a part without text.
static func text_size(control: Control) -> int:
	if not Screen.text_of(control) or control.get_theme_font(&"font") == null:
		return 0
	return control.get_theme_font_size(&"font_size")


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
	var scroll := above as ScrollContainer
	if scroll and scroll.vertical_scroll_mode != ScrollContainer.SCROLL_MODE_DISABLED:
		room = room.grow_individual(0.0, 1e6, 0.0, 1e6)
	if scroll and scroll.horizontal_scroll_mode != ScrollContainer.SCROLL_MODE_DISABLED:
		room = room.grow_individual(1e6, 0.0, 1e6, 0.0)
	for part: Control in _visible_parts(above):
		var is_blank := part is Label and not (part as Label).text.strip_edges()
		if not is_blank and not _holds(room, part.get_global_rect()):
			found.append("%s goes beyond %s" % [_title(part), _title(above)])
	return found


static func _text_that_does_not_fit(control: Control) -> PackedStringArray:
	var text := Screen.text_of(control)
	var list := control as OptionButton
	if list:
		# The arrow of the list takes some room; its text may wrap.
		var room := list.size.x - list.get_theme_stylebox(&"normal").get_minimum_size().x - 20.0
		var words: PackedStringArray = [text]
		if list.autowrap_mode != TextServer.AUTOWRAP_OFF:
			words = text.split(" ")
		for word in words:
			if _width(word, list) > room:
				return ["“%s” is cut short" % text]
		return []
	var label := control as Label
	if not label:
		return []
	if label.autowrap_mode != TextServer.AUTOWRAP_OFF:
		return _text_that_wraps_badly(label, text)
	if label.text_overrun_behavior == TextServer.OVERRUN_NO_TRIMMING:
		return []
	return [] if _width(text, label) <= label.size.x + _TOLERANCE else ["“%s” is cut short" % text]


# A line breaks only between words, and none is left out.
static func _text_that_wraps_badly(label: Label, text: String) -> PackedStringArray:
	var found: PackedStringArray = []
	for word: String in text.replace("\n", " ").split(" ", false):
		if _width(word, label) > label.size.x + _TOLERANCE:
			found.append("“%s” is broken inside, in “%s”" % [word, text])
	if label.max_lines_visible >= 0 and label.get_line_count() > label.max_lines_visible:
		found.append("“%s” is cut short" % text)
	return found


static func _width(text: String, control: Control) -> float:
	var font := control.get_theme_font(&"font")
	var font_size := control.get_theme_font_size(&"font_size")
	return font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, font_size).x


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
