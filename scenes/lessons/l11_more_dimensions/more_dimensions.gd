extends Lesson
## The lesson on more dimensions: the same dot product with three and four components.

## Ready-made vectors by their titles (source text): four components of a, four of b.
const _PRESETS: Dictionary[String, Array] = {
	"Acute": [4.0, -3.0, 2.0, 1.0, 2.0, -4.0, -1.0, 3.0],
	"Right angle": [4.0, -3.0, 2.0, 1.0, 1.0, -2.0, -5.0, 0.0],
	"Obtuse": [4.0, -3.0, 2.0, 1.0, -3.0, 2.0, 1.0, -4.0],
	"Flat": [7.0, 1.0, 0.0, 0.0, 8.0, -6.0, 0.0, 0.0],
}
# Pixels below the picture for the words there.
const _HINT_HEIGHT := 50.0

var _model := MoreDimensionsModel.new()
var _step := MoreDimensionsTexts.Step.size() - 1
var _rng := RandomNumberGenerator.new()
var _exercise: ComponentExercise
var _exercise_kind := ComponentExercise.Kind.DOT
# The vector as it was when the drag of its head began; empty while there is none.
var _held: PackedFloat64Array = []
# Why the last change could not be taken; "" where it could.
var _refusal := ""

var _steps: Steps
var _formula: MoreDimensionsFormula
var _readout: Readout
var _options: LessonOptions
var _question: Question

@onready var _picture: SpacePicture = %Picture
@onready var _bars: ComponentBars = %Bars
@onready var _stairs: ProductStairs = %Stairs
@onready var _verdict: Label = %Verdict


func start() -> void:
	_steps = services[&"steps"] as Steps
	_readout = services[&"readout"] as Readout
	_options = services[&"options"] as LessonOptions
	_question = services[&"question"] as Question
	_connect_board()
	_connect_panel()
	_ask()
	resized.connect(_show_all)
	_show_all()


func state() -> Dictionary:
	return _model.to_dictionary()


func show_state(stored: Dictionary) -> void:
	_model.from_dictionary(stored)
	_show_all()


func link_problem(linked: Dictionary) -> String:
	return MoreDimensionsModel.problem_of(linked)


func _connect_board() -> void:
	_picture.head_moved.connect(_move_head)
	_picture.turned.connect(_turn)
	_picture.head_released.connect(_finish)
	_bars.component_moved.connect(_move_component)
	_bars.component_released.connect(_finish)
	_steps.step_changed.connect(_go_to_step)


func _connect_panel() -> void:
	var panel := services[&"formula"] as Formula
	_formula = MoreDimensionsFormula.new(panel)
	panel.number_entered.connect(_enter_number)
	_options.add_switch("has_four", tr("Four components"))
	_options.switched.connect(_switch)
	for title: String in _PRESETS:
		_options.add_preset(title, tr(title))
	_options.preset_picked.connect(_set_up)
	_question.exercise_wanted.connect(_ask)
	_question.board_wanted.connect(_show_exercise.unbind(1))


# What the student does.


# Heads in space keep to whole numbers: between them, depth could not be told by eye. The way counts
# from where the drag began, or rounding would eat up its small steps.
func _move_head(letter: String, point: Vec2) -> void:
	if _held.is_empty():
		_held = (_model.a if letter == "a" else _model.b).duplicate()
	var way := point.minus(_model.view.seen_at(_held[0], _held[1], _held[2]))
	var in_space := _model.view.step_in_space(way)
	for i in 3:
		_refusal = _model.set_component(letter, i, roundf(_held[i] + in_space[i]))
	_show_model()


func _move_component(letter: String, index: int, value: float) -> void:
	_refusal = _model.set_component(letter, index, value)
	_show_model()


func _turn(yaw: float, pitch: float) -> void:
	_model.view.turn(yaw, pitch)
	_picture.show_model(_model)


func _enter_number(name_in_line: String, value: float) -> void:
	var index := name_in_line.substr(1).to_int() - 1
	_refusal = _model.set_component(name_in_line[0], index, value)
	_finish()


func _switch(key: String, on: bool) -> void:
	_model.set(key, on)
	_finish()


func _set_up(preset: String) -> void:
	var numbers: PackedFloat64Array = _PRESETS[preset]
	_model.a = numbers.slice(0, MoreDimensionsModel.MOST)
	_model.b = numbers.slice(MoreDimensionsModel.MOST)
	_finish()


func _show_exercise() -> void:
	_exercise.lay(_model)
	_finish()


func _ask() -> void:
	_exercise = ComponentExercise.fresh(_exercise_kind, _rng)
	_exercise_kind = (
		(_exercise_kind + 1) % ComponentExercise.Kind.size() as ComponentExercise.Kind
	)
	_question.show_exercise(_exercise)


func _go_to_step(step: int) -> void:
	_step = step
	_show_all()


func _finish() -> void:
	_show_all()
	edited.emit()
	noticed.emit(_refusal)
	_refusal = ""
	_held = []


# What the student sees.


func _show_all() -> void:
	_arrange()
	_picture.fit_model(_model)
	_bars.fit_model(_model)
	_options.show_switch("has_four", _model.has_four)
	_steps.show_sentences(MoreDimensionsTexts.sentences(), _step)
	_show_model()


func _show_model() -> void:
	_picture.show_model(_model)
	_bars.show_model(_model)
	(%Hint as Label).text = (
		tr("Four axes fit into no picture. The formula does not mind.")
		if _model.has_four
		else tr("Drag beside the arrows to turn the axes.")
	)
	_stairs.visible = _step >= MoreDimensionsTexts.Step.PRODUCTS
	_stairs.show_products(_model.products(), _step >= MoreDimensionsTexts.Step.SUM)
	(%VerdictCard as Control).visible = _step >= MoreDimensionsTexts.Step.SIGN
	_verdict.text = (
		"a · b %s 0\n%s"
		% [MoreDimensionsTexts.comparison(_model), MoreDimensionsTexts.sign_words(_model)]
	)
	_formula.show_model(_model, _step)
	_show_readout()


func _show_readout() -> void:
	var one := _model.counted_a()
	var other := _model.counted_b()
	var find := ComponentLists.dot.bind(one, other)
	var exact := ComponentLists.exact_dot(one, other)
	var error := exact.error_of(_model.dot())
	_readout.show_result("dot", "a · b", _model.dot(), error, CallTimer.nanoseconds(find))
	var exact_cosine := _model.exact_cosine()
	var cosine_error := exact_cosine.error_of(_model.cosine()) if exact_cosine else 0.0
	var time := CallTimer.nanoseconds(_model.cosine)
	_readout.show_result("cosine", "cos α", _model.cosine(), cosine_error, time)


# Three axes fit into a picture; with four, the bars take its place.
func _arrange() -> void:
	var gap := 8.0
	var half := Vector2((size.x - 3.0 * gap) / 2.0, (size.y - 3.0 * gap) / 2.0)
	var left := Rect2(gap, gap, half.x, size.y - 2.0 * gap - _HINT_HEIGHT)
	var top := Rect2(2.0 * gap + half.x, gap, half.x, half.y)
	_picture.visible = not _model.has_four
	_put(_picture, left)
	# The space picture leaves its corner to the card, bars fill all of it.
	var below_card := (%VerdictCard as Control).get_combined_minimum_size().y + gap
	left = left.grow_individual(0.0, -below_card, 0.0, 0.0)
	_put(_bars, left if _model.has_four else top)
	_put(%Hint as Control, Rect2(gap, left.end.y, half.x, _HINT_HEIGHT))
	_put(_stairs, Rect2(top.position.x, 2.0 * gap + half.y, half.x, half.y))
	_put(%VerdictCard as Control, Rect2(gap + 4.0, gap + 4.0, 0.0, 0.0))


func _put(control: Control, place: Rect2) -> void:
	control.position = place.position
	control.size = place.size
