@tool
class_name LineEndsDrawing
extends Control
## The five fields and the graph on the board of the lesson on line ends. In the editor it shows
## them as the lesson starts.

## The student moves the shot, in any of the fields.
signal shot_moved(tail: Vec2, head: Vec2)
## A drag or nudge of the shot has ended.
signal shot_released
## The student moves the line, in any of the fields.
signal line_moved(from: Vec2, to: Vec2)
## A drag or nudge of the line has ended.
signal line_released

# From which step on each field is shown.
const _FIRST_STEPS: Array[LineEndsTexts.Step] = [
	LineEndsTexts.Step.ONE_SIDE,
	LineEndsTexts.Step.TWO_SIDES,
	LineEndsTexts.Step.SEGMENT,
	LineEndsTexts.Step.SEGMENT,
	LineEndsTexts.Step.CAP,
]

# Which field each step is about: it is the large one.
const _ACTIVE_FIELDS: Array[LineEndsModel.Field] = [
	LineEndsModel.Field.INFINITE_ONE_SIDED,
	LineEndsModel.Field.INFINITE_TWO_SIDED,
	LineEndsModel.Field.SEGMENT_TWO_SIDED,
	LineEndsModel.Field.ROUND_CAPS,
	LineEndsModel.Field.ROUND_CAPS,
	LineEndsModel.Field.ROUND_CAPS,
	LineEndsModel.Field.ROUND_CAPS,
]

# In the order of LineEndsModel.Field.
@onready var _fields: Array[LineEndsField] = [
	%InfiniteOneSided, %InfiniteTwoSided, %SegmentOneSided, %SegmentTwoSided, %RoundCaps
]
@onready var _capped: CappedField = %RoundCaps
@onready var _graph: CapGraph = %Graph
@onready var _layout: LineEndsLayout = %Fields


func _ready() -> void:
	for field in _fields:
		field.shot_moved.connect(shot_moved.emit)
		field.shot_released.connect(shot_released.emit)
		field.line_moved.connect(line_moved.emit)
		field.line_released.connect(line_released.emit)
	resized.connect(_reserve_lines)
	_reserve_lines()
	if Engine.is_editor_hint():
		_show_start()


## Puts the shot and the line that the scene has at the start into [param model].
func put_start(model: LineEndsModel) -> void:
	_capped.put_start(model)


## Chooses the scale of every field so that the whole shot of [param model] is seen.
func fit(model: LineEndsModel) -> void:
	for field in _fields:
		field.fit(model)


## Draws [param model] up to the step [param step], counted from 0.
func show_model(model: LineEndsModel, step: int) -> void:
	for i in _fields.size():
		_fields[i].visible = _has_room_for(i, step)
		_fields[i].show_model(model, _wrong_flight(model, _fields[i].kind), step)
		_fields[i].show_name(i == _ACTIVE_FIELDS[step])
	_layout.active = _ACTIVE_FIELDS[step]
	_capped.show_cap(model, step)
	_graph.visible = step >= LineEndsTexts.Step.QUADRATIC
	_graph.shows_roots = step >= LineEndsTexts.Step.ROOTS
	var impact := model.impact_in(LineEndsModel.Field.ROUND_CAPS)
	# After its bounce the ball is no longer on the curve.
	var fraction := minf(model.fraction, impact.fraction) if impact.hit else model.fraction
	_graph.show_equation(model.cap_equation(), LineEndsTexts.end_name(model), fraction)


# A narrow, low board has room for the field that the step is about, and for the one before it until
# the graph comes.
func _has_room_for(field: int, step: int) -> bool:
	if step < _FIRST_STEPS[field]:
		return false
	if size.x >= LineEndsLayout.NARROW or size.y >= Board.SMALL:
		return true
	var active := _ACTIVE_FIELDS[step]
	return field == active or field == active - 1 and step < LineEndsTexts.Step.QUADRATIC


# No lesson runs in the editor that would call these.
func _show_start() -> void:
	var model := LineEndsModel.new()
	put_start(model)
	fit(model)
	show_model(model, LineEndsTexts.Step.size() - 1)


# The wrong ball flies in the field of the right line, so that both can be compared.
func _wrong_flight(model: LineEndsModel, kind: LineEndsModel.Field) -> BallFlight:
	if model.mistake == 0 or kind != LineEndsModel.Field.ROUND_CAPS:
		return null
	var impact := LineEndsMistakes.impact(model.mistake, model)
	return BallFlight.new(model.start, model.motion, impact)


func _reserve_lines() -> void:
	for field in _fields:
		field.reserve_lines(1 if size.x < LineEndsLayout.NARROW else 2)
