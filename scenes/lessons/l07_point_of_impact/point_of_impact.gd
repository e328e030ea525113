extends Lesson
## The lesson on position reset and point of impact: where within a frame a ball touches a line.
## Where the line and both positions of the ball are at the start is in the scene.

const _LINE: PackedFloat64Array = [60.0, 45.0, -60.0, -45.0]
const _LONG_LINE: PackedFloat64Array = [200.0, 150.0, -200.0, -150.0]
## Presets by their titles (source text): what each changes in the model's state. The speeds are
## those of the course's scenes, in pixels per frame.
const _PRESETS: Dictionary[String, Dictionary] = {
	"Course": {old = [6.0, -58.0], new = [6.0, 42.0], line = _LINE, radius = 10.0},
	"10 px": {old = [6.0, -13.0], new = [6.0, -3.0], line = _LINE, radius = 10.0},
	"38 px": {old = [6.0, -27.0], new = [6.0, 11.0], line = _LINE, radius = 10.0},
	"72 px": {old = [6.0, -44.0], new = [6.0, 28.0], line = _LINE, radius = 10.0},
	"500 px": {old = [6.0, -258.0], new = [6.0, 242.0], line = _LONG_LINE, radius = 10.0},
	"Not yet": {old = [6.0, -58.0], new = [6.0, -20.5], line = _LINE, radius = 10.0},
	"Inside": {old = [3.0, -4.0], new = [3.0, 21.0], line = _LINE, radius = 10.0},
	"Away": {old = [12.0, -16.0], new = [12.0, -66.0], line = _LINE, radius = 10.0},
	"Leaving": {old = [3.0, -4.0], new = [3.0, -29.0], line = _LINE, radius = 10.0},
	"Along": {old = [-34.0, -88.0], new = [46.0, -28.0], line = _LINE, radius = 10.0},
}

var _model := PointOfImpactModel.new()
var _formula: PointOfImpactFormula
var _readout: PointOfImpactReadout

@onready var _steps: Steps = services.get(&"steps")
@onready var _drawing: PointOfImpactDrawing = %Drawing
@onready var _line: DraggableVector = %Line
@onready var _old: BallView = %Old
@onready var _new: BallView = %New
@onready var _old_handle: BallHandle = %OldHandle
@onready var _new_handle: BallHandle = %NewHandle


func start() -> void:
	_model.line = LineSegment.new(_line.tail_point(), _line.head_point())
	_model.radius = _old.radius
	_move_old(_old.at())
	_move_new(_new.at())
	on_drag(_line.moved, _line.released, _model.move_line)
	on_drag(_old_handle.moved, _old_handle.released, _move_old)
	on_drag(_new_handle.moved, _new_handle.released, _move_new)
	on_point(MOUSE_BUTTON_LEFT, func(at: Vec2) -> void: _move_old(board.snapped_to_step(at)))
	on_point(MOUSE_BUTTON_RIGHT, func(at: Vec2) -> void: _move_new(board.snapped_to_step(at)))
	_formula = PointOfImpactFormula.new(services[&"formula"] as Formula)
	_readout = PointOfImpactReadout.new(services[&"readout"] as Readout)
	(services[&"options"] as LessonOptions).offer_presets(_PRESETS)
	(services[&"mistakes"] as Mistakes).add_all(PointOfImpactMistakes.infos())
	var kinds := PointOfImpactExercise.Kind.size()
	(services[&"question"] as Question).offer(PointOfImpactExercise.fresh, kinds)
	on_edit((services[&"formula"] as Formula).number_entered, _model.enter)
	on_pick(_take)
	begin(_model, _show, _model.points_to_show)


# What the student does.


func _move_old(to: Vec2) -> void:
	_model.old_position = to.copy()


func _move_new(to: Vec2) -> void:
	_model.new_position = to.copy()


# A mistake that changes nothing in this frame brings a frame along in which it does.
func _take(changes: Dictionary) -> String:
	var problem := _model.take(changes)
	if changes.has("mistake") and _model.mistake != 0 and not _model.shows_mistake():
		return _model.take(_PRESETS["Not yet"])
	return problem


# What the student sees.


func show_all() -> void:
	# Not during a drag: measuring would slow it down.
	_readout.measure(_model)
	super()


func _show() -> void:
	_steps.tell(PointOfImpactTexts.sentences(_model))
	_drawing.show_model(_model, _steps.step)
	_formula.show_model(_model, _steps.step)
	_readout.show_model(_model)
