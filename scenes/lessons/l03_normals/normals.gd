extends Lesson
## The lesson on normals: a line, the vector along it, and the directions that stand on it.
##
## Where the line lies at the start is in the scene: V begins and ends with it.

## Ready-made lines by their titles (source text): x and y of the start, x and y of v, times.
const _PRESETS: Dictionary[String, Array] = {
	"(3, 1)": [0.0, 0.0, 3.0, 1.0, 2.0],
	"(3, −2)": [0.0, 0.0, 3.0, -2.0, 2.0],
	"(3, −4)": [0.0, 0.0, 3.0, -4.0, 2.0],
	"In pixels": [-40.0, 60.0, 240.0, -70.0, 60.0],
	"Zero": [0.0, 0.0, 0.0, 0.0, 2.0],
}
const _LAST_STEP := 4
## The v that shows a mistake best, by the number of the mistake: x and y, in tenths.
const _EXAMPLES: Dictionary[int, Vector2i] = {6: Vector2i(0, 0), 7: Vector2i(3, 4)}

## The factor by which the unit normal is drawn longer at the start; negative for the other side.
@export_range(-100.0, 100.0, 0.5, "or_less", "or_greater") var times := 2.0

var _model := NormalsModel.new()
var _formula: NormalsFormula
var _steps: Steps
var _options: LessonOptions
var _mistakes: Mistakes
# The line before it was last dragged or typed over; null where something else has changed it.
var _before: NormalsModel
var _is_dragged := false

@onready var _drawing: NormalsDrawing = %Drawing
@onready var _v: DraggableVector = %V
@onready var _verdict: NormalsVerdict = %Verdict


func start() -> void:
	_lay_line(_v.tail_point(), _v.head_point().minus(_v.tail_point()), times)
	on_drag(_v.moved, _v.released, _drag)
	_v.released.connect(func() -> void: _is_dragged = false)
	# The card moves to another corner only when the view is fitted, not during a drag.
	board.view_changed.connect(func() -> void: _verdict.stand_behind(_model))
	_fill_panel()
	begin(_model, _show, _model.drawn_points)


func _fill_panel() -> void:
	var formula := services[&"formula"] as Formula
	_formula = NormalsFormula.new(formula)
	on_edit(formula.number_entered, _enter_number)
	_steps = services[&"steps"] as Steps
	_steps.open_at(_LAST_STEP)
	_options = services[&"options"] as LessonOptions
	_options.add_switch("is_y_up", tr("y points up"))
	_options.add_presets(_PRESETS.keys())
	on_edit(_options.switched, _model.set)
	on_edit(_options.preset_picked, _set_up)
	_mistakes = services[&"mistakes"] as Mistakes
	_mistakes.add_all(NormalsMistakes.infos())
	on_edit(_mistakes.mistake_picked, _pick_mistake)
	var question := services[&"question"] as Question
	question.offer(NormalExercise.fresh, NormalExercise.Kind.size())
	on_edit(question.board_wanted, _show_exercise)


func show_state(stored: Dictionary) -> void:
	_before = null
	super(stored)


# What the student does.


func _drag(tail: Vec2, head: Vec2) -> void:
	if not _is_dragged:
		_is_dragged = true
		_before = _model.copy()
	_model.start = tail.copy()
	_model.end = head.copy()


func _enter_number(name_in_line: String, value: float) -> void:
	_before = _model.copy()
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


func _set_up(preset: String) -> void:
	var numbers: PackedFloat64Array = _PRESETS[preset]
	var from := Vec2.new(numbers[0], numbers[1])
	_lay_line(from, Vec2.new(numbers[2], numbers[3]), numbers[4])


func _pick_mistake(number: int) -> void:
	_model.mistake = number
	if _EXAMPLES.has(number):
		var tenths := _EXAMPLES[number]
		_lay_line(Vec2.new(), Vec2.new(tenths.x / 10.0, tenths.y / 10.0), _model.times)


func _show_exercise(exercise: NormalExercise) -> void:
	_lay_line(Vec2.new(), exercise.v, _model.times)


func _lay_line(from: Vec2, v: Vec2, factor: float) -> void:
	_before = null
	_model.start = from.copy()
	_model.end = from.plus(v)
	_model.times = factor


# What the student sees.


func _show() -> void:
	board.is_y_up = _model.is_y_up
	_drawing.show_model(_model, _steps.step)
	_drawing.show_before(_before)
	_formula.show_model(_model, _steps.step)
	_verdict.show_model(_model, _before)
	_steps.tell(NormalsTexts.sentences(_model))
	_options.show_switch("is_y_up", _model.is_y_up)
	_mistakes.show_mistake(_model.mistake)
	_show_way("normal", "Vec2.normal()", _model.v().normal)
	_show_way("angle", tr("by the angle"), NormalByAngle.unit.bind(_model.v()))


func _show_way(key: String, title: String, way: Callable) -> void:
	var got: Vec2 = way.call()
	var error := ExactNormal.error_of(got, _model.v())
	var readout := services[&"readout"] as Readout
	readout.show_vector(key, title, got, error, CallTimer.nanoseconds(way), 3)
