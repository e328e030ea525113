class_name LinkView
extends RefCounted
## What a link says besides the values of the board: the step, the language, what is hidden.
## `dot_product?a=7,1&step=4&answers=off`. A new one is a line in the table and its method.

## Names that no value of a board may have.
const NAMES: PackedStringArray = [
	"step", "answers", "panel", "numbers", "lang", "angles", "y", "turn", "is_y_up"
]

const _LANGUAGE := "lang"
const _ON := "on"
const _OFF := "off"
# The conventions in a link, with what it says where they are chosen, and where not.
const _CONVENTIONS: Dictionary[String, Conventions.Choice] = {
	"angles": Conventions.Choice.RADIANS,
	"y": Conventions.Choice.Y_UP,
	"turn": Conventions.Choice.FULL_TURN,
}
const _CHOSEN: Dictionary[String, String] = {"angles": "radians", "y": "up", "turn": "full"}
const _NOT_CHOSEN: Dictionary[String, String] = {"angles": "degrees", "y": "down", "turn": "signed"}
# As older links to the lesson on normals say it.
const _OLD_Y := "is_y_up"

var _view: FrameView
# What a link can say, by its name. It is shown in this order: a new language builds the screen
# anew.
var _parts: Dictionary[String, Part]


## Something that a link can say of the view.
class Part:
	## Gets the text behind `name=`. Returns "", or one translated sentence on what is wrong.
	var problem_in: Callable
	## Gets the same text, which has no problem, and does what it says.
	var show: Callable
	## Returns the text for a link to what is shown now; "" where the link need not name it.
	var written: Callable

	func _init(its_problem_in: Callable, its_show: Callable, its_written: Callable) -> void:
		problem_in = its_problem_in
		show = its_show
		written = its_written


## Of what [param view] shows, with a lesson that has just been started.
func _init(view: FrameView) -> void:
	_view = view
	_parts = {
		"step": Part.new(_problem_of_step, _show_step, _written_step),
		"answers": Part.new(_problem_of_switch.bind("answers"), _show_answers, _unwritten),
		"panel": Part.new(_problem_of_switch.bind("panel"), _show_panel, _unwritten),
		"numbers": Part.new(_problem_of_switch.bind("numbers"), _show_numbers, _unwritten),
		_OLD_Y: Part.new(_problem_of_old_y, _show_old_y, _unwritten),
	}
	for name in _CONVENTIONS:
		_parts[name] = Part.new(
			_problem_of_convention.bind(name),
			_show_convention.bind(name),
			_written_convention.bind(name)
		)
	_parts[_LANGUAGE] = Part.new(_problem_of_language, _show_language, LabText.language_for_now)


## Speaks from now on, as long as the lab runs, the language that [param text_of_state] names, if
## there is such a one: a lesson is started in it.
static func choose_language(text_of_state: String) -> void:
	for part in text_of_state.split("&"):
		var code := part.get_slice("=", 1)
		if part.get_slice("=", 0) == _LANGUAGE and code in LabText.languages():
			LabText.speak_for_now(code)


## What [param text_of_state] says of the board: the rest of it.
func board_part(text_of_state: String) -> String:
	return _filtered(text_of_state, false)


## "" if what [param text_of_state] says of the view can be shown; else one translated sentence.
func problem_in(text_of_state: String) -> String:
	var link := _read(text_of_state)
	var problem := link.problem
	for name: String in link.state:
		if not problem:
			problem = _parts[name].problem_in.call(link.state[name])
	return problem


## Shows what [param text_of_state] says of the view, which has no [method problem_in].
func show(text_of_state: String) -> void:
	var wanted := _read(text_of_state).state
	for name in _parts:
		if wanted.has(name):
			_parts[name].show.call(wanted[name])


## What a link to what is shown now says of the view: `step=4`.
func text() -> String:
	var texts: PackedStringArray = []
	for name in _parts:
		var written: String = _parts[name].written.call()
		if written:
			texts.append("%s=%s" % [name, written])
	return "&".join(texts)


func _read(text_of_state: String) -> LessonLink:
	var view_text := _filtered(text_of_state, true)
	var base := {}
	for part in view_text.split("&", false):
		base[part.get_slice("=", 0)] = ""
	return LessonLink.read(view_text, base)


func _filtered(text_of_state: String, is_view: bool) -> String:
	var found: PackedStringArray = []
	for part in text_of_state.split("&", false):
		if _parts.has(part.get_slice("=", 0)) == is_view:
			found.append(part)
	return "&".join(found)


func _problem_of_step(wanted: String) -> String:
	var number := DecimalText.value_of(wanted)
	var count := _view.lesson.step_count
	if number == roundf(number) and number >= 1.0 and number <= count:
		return ""
	var sentence := LabText.translate("step must be a whole number within 1..%d, not “%s”.")
	return sentence % [count, LessonLink.quoted(wanted)]


func _show_step(wanted: String) -> void:
	_view.lesson.show_step(int(DecimalText.value_of(wanted)) - 1)


func _written_step() -> String:
	return str(_view.lesson.step + 1) if _view.lesson.step > 0 else ""


func _problem_of_switch(wanted: String, name: String) -> String:
	return _problem_of_choice(wanted, name, _ON, _OFF)


func _show_answers(wanted: String) -> void:
	_view.shows_answers = wanted == _ON


func _show_panel(wanted: String) -> void:
	_view.layout.show_panel(wanted == _ON)


func _show_numbers(wanted: String) -> void:
	_view.show_numbers(wanted == _ON)


# What the class sees is not what its homework hides.
func _unwritten() -> String:
	return ""


func _problem_of_convention(wanted: String, name: String) -> String:
	return _problem_of_choice(wanted, name, _NOT_CHOSEN[name], _CHOSEN[name])


func _problem_of_choice(wanted: String, name: String, one: String, other: String) -> String:
	if wanted in [one, other]:
		return ""
	var sentence := LabText.translate("%s must be %s or %s, not “%s”.")
	return sentence % [name, one, other, LessonLink.quoted(wanted)]


# As long as the lab runs: the student's own choice is another one.
func _show_convention(wanted: String, name: String) -> void:
	Conventions.choose_for_now(_CONVENTIONS[name], wanted == _CHOSEN[name])


func _written_convention(name: String) -> String:
	return _CHOSEN[name] if Conventions.is_chosen(_CONVENTIONS[name]) else ""


func _problem_of_old_y(wanted: String) -> String:
	return _problem_of_choice(wanted, _OLD_Y, "true", "false")


func _show_old_y(wanted: String) -> void:
	Conventions.choose_for_now(Conventions.Choice.Y_UP, wanted == "true")


func _problem_of_language(code: String) -> String:
	if code in LabText.languages():
		return ""
	var sentence := LabText.translate("There is no language “%s” here. There are: %s.")
	return sentence % [LessonLink.quoted(code), ", ".join(LabText.languages())]


func _show_language(code: String) -> void:
	var is_spoken := code == LabText.language()
	LabText.speak_for_now(code)
	if not is_spoken:
		_view.options.language_changed.emit()
