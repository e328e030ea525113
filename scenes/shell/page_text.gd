class_name PageText
extends Node
## The words on the screen, for the page around the lab: a screen reader cannot read a canvas.
##
## Collects what labels, fields and lists show, so that no lesson has to do anything for it.

## The words have changed.
signal changed(text: String)

## Seconds between two looks at the screen.
const INTERVAL := 0.25

var _parts: Array[Control]
var _text := ""
var _seconds := INTERVAL


## Of these parts of the screen, from top to bottom.
func _init(parts: Array[Control]) -> void:
	_parts = parts


## From now on the page is told what these parts of [param screen] show, and when the first frame
## was drawn.
static func tell_page(screen: Control, parts: Array[Control]) -> void:
	if not WebPage.is_there():
		return
	var text := PageText.new(parts)
	text.changed.connect(WebPage.show_text)
	screen.add_child(text)
	# Where a link opens a lesson at once, the start screen before it has not been drawn yet.
	if not RenderingServer.frame_post_draw.is_connected(WebPage.tell_first_frame):
		RenderingServer.frame_post_draw.connect(WebPage.tell_first_frame, CONNECT_ONE_SHOT)


## What can be read in these parts, a line each; `title: value` for what has a title.
static func of(parts: Array[Control]) -> String:
	var found: PackedStringArray = []
	for part in parts:
		found.append_array(_lines_in(part))
	return "\n".join(found)


func _process(delta: float) -> void:
	_seconds += delta
	if _seconds < INTERVAL:
		return
	_seconds = 0.0
	var text := of(_parts)
	# Nobody wants to hear every number that an opening runs through.
	if text != _text and not (_text and OpeningMotion.is_running):
		_text = text
		changed.emit(text)


static func _lines_in(control: Control) -> PackedStringArray:
	if not control.is_visible_in_tree() or not control.modulate.a:
		return []
	if control is GridContainer:
		return _rows_of(control as GridContainer)
	var lines: PackedStringArray = []
	var own := _text_of(control)
	if own:
		lines.append(own)
	for child in control.get_children():
		if child is Control:
			lines.append_array(_lines_in(child as Control))
	# What is side by side is read as one line.
	if lines and control is HBoxContainer:
		return [" ".join(lines)]
	var flows := control is HFlowContainer or control is FormulaLine
	if lines and flows and control.get_children().all(_is_part_of_formula):
		return [_formula_of(lines)]
	return lines


static func _is_part_of_formula(node: Node) -> bool:
	return node is Label or node is LineEdit


# It has its spaces already, and some more around numbers that can be typed over.
static func _formula_of(texts: PackedStringArray) -> String:
	var formula := "".join(texts)
	for pair: PackedStringArray in [["( ", "("], [" )", ")"], [" ,", ","]]:
		formula = formula.replace(pair[0], pair[1])
	return RegEx.create_from_string(" {2,}").sub(formula.strip_edges(), "  ", true)


# A table: the first column is what its row is about. Where the first row has no title it holds the
# headings; the heading of the first column of values is left out.
static func _rows_of(table: GridContainer) -> PackedStringArray:
	var cells: PackedStringArray = []
	for child in table.get_children():
		if child is Control and (child as Control).visible:
			cells.append(" ".join(_lines_in(child as Control)))
	var has_headings := cells.size() > 0 and cells[0] == ""
	var lines: PackedStringArray = []
	for at in range(table.columns if has_headings else 0, cells.size(), table.columns):
		var values: PackedStringArray = []
		for column in range(1, table.columns):
			var value := cells[at + column] if at + column < cells.size() else ""
			if value:
				var is_named := has_headings and column > 1
				values.append(("%s %s" % [cells[column], value]) if is_named else value)
		lines.append("%s: %s" % [cells[at], ", ".join(values)])
	return lines


# Buttons are left out: they say what can be done, not what is shown.
static func _text_of(control: Control) -> String:
	if control is Label:
		# Where a line breaks is of no interest here.
		return control.atr((control as Label).text).replace("\u00a0", " ")
	if control is LineEdit:
		return (control as LineEdit).text
	if control is RichTextLabel:
		return (control as RichTextLabel).get_parsed_text()
	if control is OptionButton:
		var title := control.atr(control.accessibility_name)
		return "%s: %s" % [title, (control as OptionButton).text]
	return ""
