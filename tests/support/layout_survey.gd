class_name LayoutSurvey
extends RefCounted
## Looks at a lesson in a window at each step, in states that its presets and mistakes lead to and
## in extreme ones, and while it plays; collects what is too small, lies on something else, is cut
## off or moves.

## What is smaller can hardly be hit with a finger or read, in pixels of the window.
const SMALLEST_TARGET := 44.0
const SMALLEST_TEXT := 14.0
## Frames for which it plays.
const FRAMES := 20

const _SETTLING := 2
const _SEED := 5
# Rounding of places.
const _TOLERANCE := 0.6

## What is wrong, once a kind, with where it was seen first.
var problems: Dictionary[String, String] = {}
## The smallest target, in pixels of the window, and what it is.
var smallest_target := INF
var smallest_target_name := ""
## The smallest text, in pixels of the window, and what it is.
var smallest_text := INF
var smallest_text_name := ""

var _frame: LessonFrame
var _texts := BoardTexts.new()


## Looks at the lesson that [param frame] has opened: at all its steps, or at the last one only,
## then there in its first [param state_count] states, and last while it plays.
func look_at(
	frame: LessonFrame, where: String, state_count: int, at_every_step: bool = true
) -> void:
	_frame = frame
	var steps: Steps = frame.lesson.services.get(&"steps")
	if steps and not at_every_step:
		steps.go_to(1000)
	var last := -1
	while steps and steps.step > last:
		last = steps.step
		var step := "%s, step %d" % [where, last + 1]
		await _look(step)
		# A card with larger text takes more room than a phone has beside the drawing.
		if WindowFit.text_size() == WindowFit.TEXT_SIZES[0]:
			for problem in _texts.covered_ones():
				_note(problem, step)
		steps.go_to(last + 1)
	if state_count > 0:
		await _look_at_states(where, state_count)
	await _play(where)


func _look_at_states(where: String, state_count: int) -> void:
	var lesson := _frame.lesson
	var first := lesson.state().duplicate(true)
	var states := LessonStates.new(lesson, _SEED)
	for number in state_count:
		var state := states.state(number)
		if not lesson.link_problem(state):
			lesson.show_link(state)
			await _look("%s, state %d" % [where, number])
	lesson.show_state(first)


# What moves on the board moves nothing in the panel.
func _play(where: String) -> void:
	var transport: Transport = _frame.lesson.services.get(&"transport")
	if not transport:
		return
	await _settle()
	transport.is_playing = true
	await _settle()
	var before := _places()
	for i in FRAMES:
		await _frame.get_tree().process_frame
		# What has come to its end takes no more room than it needs.
		if not transport.is_playing:
			break
		var now := _places()
		for part: String in before:
			var old: Rect2 = before[part]
			var new: Rect2 = now.get(part, Rect2())
			if not old.position.is_equal_approx(new.position) or not _is_same(old.size, new.size):
				_note("%s moves while it plays" % part, where)
	transport.is_playing = false
	await _look(where + ", played")


func _is_same(one: Vector2, other: Vector2) -> bool:
	return one.distance_to(other) < _TOLERANCE


# Where the services and what can be pressed in them are.
func _places() -> Dictionary[String, Rect2]:
	var places: Dictionary[String, Rect2] = {}
	for service: Node in _frame.get_node("%Services").get_children():
		if (service as Control).visible:
			places[str(service.name)] = (service as Control).get_global_rect()
			for control: Control in Screen.controls(service):
				if control is BaseButton or control is LineEdit:
					places["%s %s" % [_kind_of(control), places.size()]] = control.get_global_rect()
	return places


func _look(where: String) -> void:
	await _settle()
	_texts.listen(_frame.lesson)
	await _frame.get_tree().process_frame
	_note_text(_texts.smallest() * _scale(_frame), "text on the board", where)
	for problem in _texts.cut_off_ones():
		_note(problem, where)
	for problem in Layout.problems(_frame):
		_note(problem, where)
	for problem in Layout.card_problems(_frame.lesson):
		_note(problem, where)
	measure(_frame, where)


## Measures what is to be hit and read on [param screen].
func measure(screen: Control, where: String) -> void:
	var scale := _scale(screen)
	for control: Control in Screen.controls(screen):
		var side := minf(control.size.x, control.size.y) * scale
		var title := _kind_of(control)
		if Layout.is_target(control):
			if side < smallest_target:
				smallest_target = side
				smallest_target_name = "%s in %s" % [title, where]
			if side < SMALLEST_TARGET - 0.01:
				_note("%s is a target of %.1f px" % [title, side], where)
		var text := Layout.text_size(control) * scale
		if text > 0.0:
			_note_text(text, title, where)


func _note_text(text: float, title: String, where: String) -> void:
	if text < smallest_text:
		smallest_text = text
		smallest_text_name = "%s in %s" % [title, where]
	if text < SMALLEST_TEXT - 0.01:
		_note("%s is a text of %.1f px" % [title, text], where)


# Pixels of the window, as CSS counts them, in one of the drawing.
static func _scale(screen: Control) -> float:
	var window := screen.get_window()
	var density := DisplayServer.screen_get_scale(window.current_screen)
	return window.get_final_transform().get_scale().x / density


# The same for every number in a formula, and for every preset.
static func _kind_of(control: Control) -> String:
	var script: Script = control.get_script()
	var kind := control.get_class()
	if script:
		kind = script.get_global_name()
	return "%s of %s" % [kind, _named(control.get_parent()).name]


# The nearest node that has a name of its own.
static func _named(node: Node) -> Node:
	return _named(node.get_parent()) if str(node.name).begins_with("@") else node


func _note(problem: String, where: String) -> void:
	if not problems.has(problem):
		problems[problem] = where


func _settle() -> void:
	for i in _SETTLING:
		await _frame.get_tree().process_frame
