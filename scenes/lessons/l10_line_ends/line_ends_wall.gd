@tool
class_name LineEndsWall
extends BoardPart
## A line of one of the five kinds, with the dashed outline at which the ball's centre turns back,
## and a normal to every side that works.

const _DASH_ANGLE := 0.16
const _NORMAL_PIXELS := 26.0
# Where along the line the normals are, as a share of its length: the shot at the start does not
# cover them there.
const _NORMAL_SHARE := 0.7

var _field := LineEndsModel.Field.ROUND_CAPS
# null before the line is known.
var _segment: LineSegment
var _radius := 1.0


## Shows the line of [param model] as the kind [param field] has it.
func show_model(model: LineEndsModel, field: LineEndsModel.Field) -> void:
	_field = field
	_segment = model.segment.copy()
	_radius = model.radius
	queue_redraw()


func _draw() -> void:
	if not _segment:
		return
	var from := board.to_screen(_segment.start)
	var to := board.to_screen(_segment.end)
	var along := board.direction_to_screen(_segment.along().normalized())
	if _is_infinite():
		var far := along * (board.size.length() + from.distance_to(to))
		from -= far
		to += far
		draw_line(from, to, Palette.color(Palette.Role.INK), 3.0, true)
	var normal := board.direction_to_screen(_segment.normal())
	_draw_side(from, to, normal)
	if _is_two_sided():
		_draw_side(from, to, -normal)
	if _field == LineEndsModel.Field.ROUND_CAPS:
		_draw_cap(from, (-along).angle())
		_draw_cap(to, along.angle())


func _is_infinite() -> bool:
	return (
		_field == LineEndsModel.Field.INFINITE_ONE_SIDED
		or _field == LineEndsModel.Field.INFINITE_TWO_SIDED
	)


func _is_two_sided() -> bool:
	return (
		_field != LineEndsModel.Field.INFINITE_ONE_SIDED
		and _field != LineEndsModel.Field.SEGMENT_ONE_SIDED
	)


func _draw_side(from: Vector2, to: Vector2, normal: Vector2) -> void:
	var away := normal * _radius * board.pixels_per_unit
	draw_strokes(from + away, to + away, Palette.color(Palette.Role.QUIET), 1.5)
	var middle := board.to_screen(_segment.start.lerped(_segment.end, _NORMAL_SHARE))
	var tip := middle + normal * _NORMAL_PIXELS
	var color := Palette.color(Palette.Role.UNIT)
	draw_line(middle, tip - normal * 8.0, color, 3.0, true)
	var side := normal.orthogonal() * 5.0
	var neck := tip - normal * 10.0
	var corners: PackedVector2Array = [tip, neck + side, neck - side]
	draw_primitive(corners, [color], [])


# Half a circle around an end, from one parallel to the other.
func _draw_cap(end: Vector2, outwards: float) -> void:
	var pixels := _radius * board.pixels_per_unit
	var color := Palette.color(Palette.Role.QUIET)
	var angle := outwards - PI / 2.0
	while angle < outwards + PI / 2.0:
		draw_arc(end, pixels, angle, angle + _DASH_ANGLE * 0.6, 4, color, 1.5, true)
		angle += _DASH_ANGLE
