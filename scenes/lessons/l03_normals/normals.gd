extends Lesson
## The lesson on normals: a line, the vector along it, and the directions that stand on it.

const _STEP_COUNT := 5

## Ready-made lines by their titles (source text): x and y of the start, x and y of v, times.
const _PRESETS: Dictionary[String, Array] = {
	"(3, 1)": [0.0, 0.0, 3.0, 1.0, 2.0],
	"(3, −2)": [0.0, 0.0, 3.0, -2.0, 2.0],
	"(3, −4)": [0.0, 0.0, 3.0, -4.0, 2.0],
	"In pixels": [-40.0, 60.0, 240.0, -70.0, 60.0],
	"Zero": [0.0, 0.0, 0.0, 0.0, 2.0],
}

## What shows a mistake best: x and y of v, by the number of the mistake.
const _EXAMPLES: Dictionary[int, Vector2i] = {6: Vector2i(0, 0), 7: Vector2i(3, 4)}

var _model := NormalsModel.new()
var _step := _STEP_COUNT - 1
var _rng := RandomNumberGenerator.new()
var _exercise: NormalExercise
var _exercise_kind := NormalExercise.Kind.NORMAL
# The line before the drag that is going on or was the last one; null where there is none.
var _before: NormalsModel
var _is_dragging := false

var _steps: Steps
var _formula: NormalsFormula
var _readout: Readout
var _options: LessonOptions
var _mistakes: Mistakes
var _question: Question

@onready var _drawing: NormalsDrawing = %Drawing
@onready var _v: DraggableVector = %V
@onready var _verdict: NormalsVerdict = %Verdict


func start() -> void:
	_bring_services()
	_v.moved.connect(_drag)
	_v.released.connect(_finish_drag)
	_steps.step_changed.connect(_go_to_step)
	_connect_formula()
	_fill_options()
	_ask()
	resized.connect(_show_all)
	_show_all()


func state() -> Dictionary:
	return _model.to_dictionary()


func show_state(stored: Dictionary) -> void:
	_model.from_dictionary(stored)
	_before = null
	_show_all()


func link_problem(linked: Dictionary) -> String:
	var number: int = linked["mistake"]
	return StateCheck.mistake(number, NormalsTexts.mistakes())


func _bring_services() -> void:
	_steps = services[&"steps"] as Steps
	_readout = services[&"readout"] as Readout
	_options = services[&"options"] as LessonOptions
	_mistakes = services[&"mistakes"] as Mistakes
	_question = services[&"question"] as Question


func _connect_formula() -> void:
	var panel := services[&"formula"] as Formula
	_formula = NormalsFormula.new(panel)
	panel.number_entered.connect(_enter_number)


func _fill_options() -> void:
	_options.add_switch("is_y_up", tr("y points up"))
	_options.switched.connect(_switch)
	for title: String in _PRESETS:
		_options.add_preset(title, tr(title))
	_options.preset_picked.connect(_set_up)
	for mistake in NormalsTexts.mistakes():
		_mistakes.add_mistake(mistake)
	_mistakes.mistake_picked.connect(_pick_mistake)
	_question.exercise_wanted.connect(_ask)
	_question.board_wanted.connect(_show_exercise.unbind(1))


# What the student does.


func _drag(tail: Vec2, head: Vec2) -> void:
	if not _is_dragging:
		_is_dragging = true
		_before = _copy_of_model()
	_model.start = tail.copy()
	_model.end = head.copy()
	_show_model()


func _finish_drag() -> void:
	_is_dragging = false
	_finish()


func _enter_number(name_in_line: String, value: float) -> void:
	_before = _copy_of_model()
	var v := _model.v()
	match name_in_line:
		"vx":
			v.x = value
		"vy":
			v.y = value
		"sx":
			_model.start.x = value
		"sy":
			_model.start.y = value
		"k":
			_model.times = value
	_model.end = _model.start.plus(v)
	_finish()


func _switch(key: String, on: bool) -> void:
	_model.set(key, on)
	_finish()


func _set_up(preset: String) -> void:
	var numbers: PackedFloat64Array = _PRESETS[preset]
	var from := Vec2.new(numbers[0], numbers[1])
	_lay_line(from, Vec2.new(numbers[2], numbers[3]), numbers[4])


func _pick_mistake(number: int) -> void:
	_model.mistake = number
	if _EXAMPLES.has(number):
		var tenths := _EXAMPLES[number]
		_lay_line(Vec2.new(), Vec2.new(tenths.x / 10.0, tenths.y / 10.0), _model.times)
	else:
		_finish()


func _show_exercise() -> void:
	_lay_line(Vec2.new(), _exercise.v, _model.times)


func _lay_line(from: Vec2, v: Vec2, times: float) -> void:
	_before = null
	_model.start = from
	_model.end = from.plus(v)
	_model.times = times
	_finish()


func _ask() -> void:
	_exercise = NormalExercise.fresh(_exercise_kind, _rng)
	_exercise_kind = (_exercise_kind + 1) % NormalExercise.Kind.size() as NormalExercise.Kind
	_question.show_exercise(_exercise)


func _go_to_step(step: int) -> void:
	_step = step
	_show_all()


func _finish() -> void:
	_show_all()
	edited.emit()


func _copy_of_model() -> NormalsModel:
	var copy := NormalsModel.new()
	copy.from_dictionary(_model.to_dictionary())
	return copy


# What the student sees.


func _show_all() -> void:
	board.is_y_up = _model.is_y_up
	var from := _model.start
	var wide: Array[Vec2] = [from, _model.end]
	for arm: Vec2 in [_model.normal(), _model.opposite(), _model.unit()]:
		wide.append(from.plus(arm))
	if _model.mistake == 0:
		wide.append(_model.middle().plus(_model.scaled()))
	board.fit(wide)
	_options.show_switch("is_y_up", _model.is_y_up)
	_mistakes.show_mistake(_model.mistake)
	_steps.show_sentences(NormalsTexts.sentences(_model), _step)
	_show_model()
	_verdict.stand_behind(_model)


func _show_model() -> void:
	_drawing.show_model(_model, _step)
	if _before:
		_drawing.show_before(_before.start, _before.v())
	else:
		_drawing.hide_before()
	_formula.show_model(_model, _step)
	_verdict.show_model(_model, _before)
	_show_readout()


func _show_readout() -> void:
	var v := _model.v()
	_show_way("normal", "Vec2.normal()", v.normal)
	_show_way("angle", tr("by the angle"), NormalByAngle.unit.bind(v))


func _show_way(key: String, title: String, way: Callable) -> void:
	var got: Vec2 = way.call()
	var value := NumberText.pair(got.x, got.y, 3)
	var error := NumberText.size(ExactNormal.error_of(got, _model.v()))
	var time := tr("%s ns") % NumberText.short(CallTimer.nanoseconds(way), 2)
	_readout.show_texts(key, [title, value, error, time])
