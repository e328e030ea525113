class_name SeenLesson
extends RefCounted
## What a student sees of an open lesson: texts only, and the state that they are about.

static var _number_finder := RegEx.create_from_string("^-?(?:\\d+(?:\\.\\d+)?(?:e-?\\d+)?|∞)")

static var _share_finder := RegEx.create_from_string("^(-?)(\\d*)π(?:/(\\d+))?")

## The lesson's link state.
var state: Dictionary
## The step, counted from 0.
var step: int
## The sentence of the step.
var sentence := ""
## The letter on the ball of the verdict card; "" where no card is shown.
var verdict_sign := ""
## The lines of the verdict card.
var verdict: PackedStringArray = []
## The rows of the readout, without its headings.
var rows: Array[PackedStringArray] = []
## The lines of the formula.
var lines: PackedStringArray = []
## The texts drawn on the board, such as the label of an arrow.
var labels: PackedStringArray = []
## The notice above the board.
var notice := ""
## What is said of work that takes a while.
var progress := ""


## What [param frame] shows now.
static func of(frame: LessonFrame) -> SeenLesson:
	var seen := SeenLesson.new()
	seen.state = frame.lesson.link_state()
	seen.step = frame.lesson.step
	seen._read_services(frame.lesson.services)
	seen._read_board(frame.lesson.board)
	var notice_label := frame.get_node("%Notice") as Label
	seen.notice = notice_label.text if notice_label.is_visible_in_tree() else ""
	return seen


## The number behind [param words] in [param text]; NAN where there is none.
static func number_behind(words: String, text: String) -> float:
	var at := text.find(words)
	return NAN if at < 0 else first_number(text.substr(at + words.length()))


## The angle behind [param words] in [param text], in degrees, where it is written in the unit that
## the lab uses: `53.13°`, or `0.9273 rad`, `0.9273` and `3π/4`. NAN where there is none.
static func degrees_behind(words: String, text: String) -> float:
	var at := text.find(words)
	if at < 0:
		return NAN
	var angle := text.substr(at + words.length()).strip_edges().replace(NumberText.MINUS, "-")
	var share := _share_finder.search(angle)
	if not Conventions.uses_radians():
		return NAN if share else first_number(angle)
	if not share:
		return rad_to_deg(first_number(angle))
	var times := share.get_string(2).to_float() if share.get_string(2) else 1.0
	var below := share.get_string(3).to_float() if share.get_string(3) else 1.0
	return (-180.0 if share.get_string(1) else 180.0) * times / below


## The number with which [param text] begins; NAN where it begins with something else.
static func first_number(text: String) -> float:
	var found := _number_finder.search(text.strip_edges().replace(NumberText.MINUS, "-"))
	return found.get_string().replace("∞", "inf").to_float() if found else NAN


## Whether [param shown] can stand for [param wanted]: within one unit of its fourth digit, and
## within [param rounding], what double numbers may be off by.
static func is_close(shown: float, wanted: float, rounding: float) -> bool:
	if shown == wanted:
		return true
	if wanted == 0.0:
		return absf(shown) <= rounding
	var unit := 10.0 ** (floorf(log(absf(wanted)) / log(10.0)) - 3.0)
	return absf(shown - wanted) <= unit * 1.0001 + rounding


## The same for an angle in degrees, of which the lab shows four digits in its own unit.
static func is_close_angle(shown: float, wanted: float, rounding: float) -> bool:
	if not Conventions.uses_radians():
		return is_close(shown, wanted, rounding)
	return is_close(deg_to_rad(shown), deg_to_rad(wanted), deg_to_rad(rounding))


func _read_services(services: Dictionary[StringName, Control]) -> void:
	if services.has(&"steps"):
		sentence = (services[&"steps"].get_node("%Sentence") as Label).text
		sentence = sentence.replace(Steps.NO_BREAK_SPACE, " ")
	if services.has(&"formula"):
		lines = Screen.lines(services[&"formula"] as Formula)
	if services.has(&"progress"):
		progress = (services[&"progress"].get_node("%Words") as Label).text
	var readout: Readout = services.get(&"readout")
	if not readout or not readout.is_visible_in_tree():
		return
	for at in range(1, readout.row_count()):
		if not readout.cell(at, 0).visible:
			continue
		var row: PackedStringArray = []
		for column in 4:
			row.append(readout.cell(at, column).text)
		rows.append(row)


func _read_board(part: Node) -> void:
	# What was replaced is freed at the end of a frame.
	if part.is_queued_for_deletion() or part is CanvasItem and not (part as CanvasItem).visible:
		return
	if part is VerdictCard:
		verdict_sign = (part.get_node("%Sign") as Label).text
		var words := (part.get_node("%Words") as Label).text
		verdict = words.replace(Steps.NO_BREAK_SPACE, " ").split("\n")
		return
	if part is StabilityMark:
		labels.append((part as StabilityMark).accessibility_name)
	for property: StringName in [&"label", &"text", &"note", &"left_sentence", &"right_sentence"]:
		var text: Variant = part.get(property)
		if text is String and text:
			labels.append(str(text))
	for child in part.get_children():
		_read_board(child)
