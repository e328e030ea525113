class_name Question
extends FoldableContainer
## A question, at first with the lecture's numbers and then with fresh ones: takes an answer, checks
## it, and says which mistake leads to a wrong one. Who gives up is shown the solution.

## The student wants to see the numbers of the question [param exercise] on the board.
signal board_wanted(exercise: Exercise)
## The same as a change of the lesson's state, where [method Exercise.board_state] has one.
signal picked(changes: Dictionary)
## An answer was checked.
signal answered(is_right: bool)

## Draws the numbers of the questions.
var rng := RandomNumberGenerator.new()

var _exercise: Exercise
# Makes an exercise of a kind, counted from 0, with a generator of random numbers.
var _fresh: Callable
var _kind_count := 1
var _kind := 0
# Those with the lecture's numbers that have not been asked yet.
var _of_the_lecture: Array[Exercise] = []
var _fields: Array[LineEdit] = []

@onready var _prompt: Label = %Prompt
@onready var _answers: HFlowContainer = %Answers
@onready var _check: Button = %Check
@onready var _verdict: Label = %Verdict
@onready var _solution: Label = %Solution
@onready var _show: Button = %Show


func _ready() -> void:
	_check.pressed.connect(_check_answer)
	(%New as Button).pressed.connect(_ask)
	(%ShowSolution as Button).pressed.connect(_show_solution)
	_show.pressed.connect(_show_on_board)


## Asks questions that [param fresh] makes: it takes a kind, from 0 to [param kind_count] - 1, and
## a [RandomNumberGenerator], and returns an [Exercise]. It is called again while two mistakes would
## lead to the same answer. The kinds take turns, from [param first_kind]. Before them come those of
## [param of_the_lecture], which takes a kind and returns the exercise with the lecture's own
## numbers, or null where the lecture has none.
func offer(
	fresh: Callable, kind_count: int, first_kind: int = 0, of_the_lecture: Callable = Callable()
) -> void:
	_fresh = fresh
	_kind_count = kind_count
	_kind = first_kind
	_of_the_lecture.clear()
	if of_the_lecture:
		for i in kind_count:
			var exercise: Exercise = of_the_lecture.call((first_kind + i) % kind_count)
			if exercise:
				_of_the_lecture.append(exercise)
	_ask()


## The same for all kinds in the `enum Kind` of [param exercises], a class of [Exercise] with a
## static method `fresh`.
func offer_kinds(exercises: GDScript, first_kind: int, of_the_lecture: Callable) -> void:
	var kinds: Dictionary = exercises.get_script_constant_map()["Kind"]
	offer(Callable(exercises, &"fresh"), kinds.size(), first_kind, of_the_lecture)


# What was answered before is cleared.
func _ask() -> void:
	_exercise = _next_exercise()
	_prompt.text = Conventions.in_unit(_exercise.prompt)
	_verdict.text = ""
	_solution.hide()
	_show.disabled = true
	# The lesson may connect to the signal after its first question.
	_offer_board.call_deferred()
	for child in _answers.get_children():
		child.queue_free()
	_fields.clear()
	for answer_title in _exercise.answer_titles:
		_add_field(answer_title)


func _next_exercise() -> Exercise:
	if _of_the_lecture:
		return _of_the_lecture.pop_front()
	var exercise := Exercise.drawn(_fresh, _kind, rng)
	_kind = (_kind + 1) % _kind_count
	return exercise


# Where nothing listens, the numbers cannot be shown on the board.
func _offer_board() -> void:
	var is_taken := picked.has_connections() and not _exercise.board_state().is_empty()
	_show.visible = is_taken or board_wanted.has_connections()


## Shows the question, and its solution, in the unit of angles that is chosen now.
func show_picked(_state: Dictionary) -> void:
	if _exercise:
		_prompt.text = Conventions.in_unit(_exercise.prompt)
		_solution.text = Conventions.in_unit(_exercise.solution())


func _show_solution() -> void:
	_solution.text = Conventions.in_unit(_exercise.solution())
	_solution.show()
	_show.disabled = false


func _show_on_board() -> void:
	board_wanted.emit(_exercise)
	if not _exercise.board_state().is_empty():
		picked.emit(_exercise.board_state())


func _add_field(answer_title: String) -> void:
	var label := Label.new()
	label.text = answer_title
	label.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	var field := LineEdit.new()
	field.accessibility_name = answer_title
	field.custom_minimum_size.x = 90.0
	field.text_submitted.connect(func(_text: String) -> void: _check_answer())
	_answers.add_child(label)
	_answers.add_child(field)
	_fields.append(field)


func _check_answer() -> void:
	var answer: PackedFloat64Array = []
	for field in _fields:
		var problem := NumberText.problem(field.text)
		if problem:
			_say(problem, Palette.Role.WRONG)
			field.grab_focus()
			return
		answer.append(NumberText.parse(field.text))
	var verdict := _exercise.check(answer)
	_say(verdict.sentence, Palette.Role.RIGHT if verdict.is_right else Palette.Role.WRONG)
	_show.disabled = false
	answered.emit(verdict.is_right)


func _say(sentence: String, role: Palette.Role) -> void:
	_verdict.text = Conventions.in_unit(sentence)
	_verdict.add_theme_color_override(&"font_color", Palette.color(role))
