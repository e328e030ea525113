extends Lesson
## The lesson on normals: a line, the vector along it, and the directions that stand on it.
##
## Where the line lies at the start is in the scene: V begins and ends with it.

## The line that shows a mistake best, by the number of the mistake; none for the others.
const _EXAMPLES: Dictionary[int, Dictionary] = {
	NormalsMistakes.ZERO_VECTOR: {line = [0.0, 0.0, 0.0, 0.0]},
	NormalsMistakes.CUT_LENGTH: {line = [0.0, 0.0, 0.3, 0.4]},
}

# The switch that turns the picture over.
const _Y_UP := "is_y_up"
# At the opening v swings by so many degrees to either side.
const _SWING := 20.0

## The factor by which the unit normal is drawn longer at the start; negative for the other side.
@export_range(-100.0, 100.0, 0.5, "or_less", "or_greater") var times := 2.0

var _model := NormalsModel.new()
# The line before it was last dragged or typed over; null where it was set up in another way.
var _before: NormalsModel
var _is_dragged := false

@onready var _readout: Readout = services.get(&"readout")
@onready var _drawing: NormalsDrawing = %Drawing
@onready var _v: DraggableVector = %V
@onready var _verdict: NormalsVerdict = %Verdict


func start() -> void:
	_model.lay(_v.tail_point(), _v.head_point())
	_model.times = times
	on_drag(_v.moved, _v.released, _drag)
	_v.released.connect(func() -> void: _is_dragged = false)
	# The card moves to another corner only when the view is fitted, not during a drag.
	board.view_changed.connect(func() -> void: _verdict.stand_behind(_model))
	show_in_panel(NormalsFormula.new(services[&"formula"] as Formula))
	on_enter(_enter)
	add_switch(_Y_UP, tr("y points up"))
	offer_presets(NormalsModel.PRESETS)
	offer_mistakes(NormalsMistakes.infos())
	offer_questions(NormalExercise, NormalExercise.of_the_lecture)
	on_pick(_pick)
	begin(_model, _show, _model.points_to_show)
	ask_choice_before(
		NormalsTexts.Step.OPPOSITE,
		tr("v has a second normal, on the other side. Which one?"),
		["(y, x)", "(y, −x)", "(−y, −x)"],
		func() -> int: return 1 if _has_question() else -1
	)
	open_with_swing(_swing.bind(_model.v()))


# Undo, reset and links do not tell what was before.
func show_state(stored: Dictionary) -> void:
	_before = null
	super(stored)


# What moves by itself: the end swings, to hundredths, so that the numbers stay short.
func _swing(share: float, v: Vec2) -> void:
	var swung := v.copy()
	swung.rotate_degrees(_SWING * share)
	var end := _model.start.plus(swung)
	_model.end.set_xy(snappedf(end.x, 0.01), snappedf(end.y, 0.01))


# What the student does.


func _drag(tail: Vec2, head: Vec2) -> void:
	if not _is_dragged:
		_is_dragged = true
		_before = _model.copy()
	_model.lay(tail, head)


func _enter(name_in_line: String, value: float) -> String:
	_before = _model.copy() if name_in_line != "k" else null
	return _model.enter(name_in_line, value)


# Which way y points is chosen for the whole lab.
func _pick(changes: Dictionary) -> String:
	if changes.has(_Y_UP):
		var is_up: bool = changes[_Y_UP]
		Conventions.choose(Conventions.Choice.Y_UP, is_up)
		return ""
	var mistake: int = changes.get("mistake", 0)
	var example: Dictionary = _EXAMPLES.get(mistake, {})
	var all_changes := changes.merged(example)
	if all_changes.has("line"):
		_before = null
	return _model.take(all_changes)


# What the student sees.


func _show() -> void:
	(services[&"options"] as LessonOptions).show_switch(_Y_UP, Conventions.is_y_up())
	ask_before(
		NormalsTexts.Step.NORMAL,
		NormalsTexts.question(),
		func() -> Vec2: return _model.start.plus(_model.normal()) if _has_question() else null,
		func() -> Vec2: return _model.end
	)
	tell_steps(NormalsTexts.sentences(_model))
	_drawing.show_model(_model, step)
	_drawing.show_before(_before)
	tell_code(NormalsCode.lines(_model, step), NormalsCode.inputs(_model))
	_verdict.show_model(_model, _before, step)
	_readout.visible = step >= NormalsTexts.Step.UNIT
	if _readout.visible:
		_show_way("formula", "(−y, x) / |v|", NormalByFormula.unit.bind(_model.v()))
		_show_way("angle", tr("by the angle"), NormalByAngle.unit.bind(_model.v()))
		_show_way("normal", "Vec2.normal()", _model.v().normal)


# A zero v has no normals, and a mistake is beside the steps.
func _has_question() -> bool:
	return _model.has_direction() and _model.mistake == 0


func _show_way(key: String, title: String, way: Callable) -> void:
	var got: Vec2 = way.call()
	var error := ExactNormal.error_of(got, _model.v())
	_readout.show_vector(key, title, got, error, CallTimer.nanoseconds(way), 3)
