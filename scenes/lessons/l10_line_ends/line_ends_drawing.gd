class_name LineEndsDrawing
extends Control
## The five fields and the graph on the board of the lesson on line ends.

## The student moves the shot, in any of the fields.
signal shot_moved(tail: Vec2, head: Vec2)
## The student moves the line, in any of the fields.
signal line_moved(from: Vec2, to: Vec2)
## A drag or nudge has ended.
signal released

# From which step on each field is shown.
const _FIRST_STEPS: Array[LineEndsTexts.Step] = [
	LineEndsTexts.Step.ONE_SIDE,
	LineEndsTexts.Step.TWO_SIDES,
	LineEndsTexts.Step.SEGMENT,
	LineEndsTexts.Step.SEGMENT,
	LineEndsTexts.Step.CAP,
]

# In the order of LineEndsModel.Field.
@onready var _fields: Array[LineEndsField] = [
	%InfiniteOneSided, %InfiniteTwoSided, %SegmentOneSided, %SegmentTwoSided, %RoundCaps
]
@onready var _capped: CappedField = %RoundCaps
@onready var _graph: CapGraph = %Graph


func _ready() -> void:
	for field in _fields:
		field.shot_moved.connect(shot_moved.emit)
		field.line_moved.connect(line_moved.emit)
		field.released.connect(released.emit)
	resized.connect(_arrange)
	_arrange()


## Chooses the scale of every field so that the shot of [param model] is seen.
func fit(model: LineEndsModel) -> void:
	for field in _fields:
		field.fit(model)


## Draws [param model] as far as [param step], counted from 0, has got.
func show_model(model: LineEndsModel, step: int) -> void:
	for i in _fields.size():
		_fields[i].visible = step >= _FIRST_STEPS[i]
		_fields[i].show_model(model, _wrong_flight(model, _fields[i].kind))
	_capped.show_cap(model, step)
	_graph.visible = step >= LineEndsTexts.Step.QUADRATIC
	_graph.show_equation(model.cap_equation(), LineEndsTexts.end_name(model), model.fraction)


# The wrong ball flies in the field of the right line, so that both can be compared.
func _wrong_flight(model: LineEndsModel, kind: LineEndsModel.Field) -> BallFlight:
	if model.mistake == 0 or kind != LineEndsModel.Field.ROUND_CAPS:
		return null
	var impact := LineEndsMistakes.impact(model.mistake, model)
	return BallFlight.new(model.start, model.motion, impact)


func _arrange() -> void:
	var places := LineEndsLayout.places(size)
	for i in _fields.size():
		_fields[i].position = places[i].position
		_fields[i].reserve_lines(1 if size.x < LineEndsLayout.NARROW else 2)
		_fields[i].size = places[i].size
	_graph.position = places[-1].position
	_graph.size = places[-1].size
