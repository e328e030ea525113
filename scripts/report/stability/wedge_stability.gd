class_name WedgeStability
extends StabilityFamily
## A ball shot into a wedge comes out again after a number of bounces that unfolding gives: the
## mirrored wedges lie around the corner like the slices of a cake, the path is a straight line
## through them, and it crosses one of their sides at each bounce.

const _DEGREES: PackedFloat64Array = [60.0, 10.0, 1.0, 0.01]
# The trial of a sharper wedge takes long.
const _SHARP := 1.0

const _RADIUS := 10.0
# The distance of the ball's centre at the start from the corner of the wedge in which the centre
# can move, in pixels.
const _START := 1e5
# The direction of the shot, as a fraction of the wedge's angle off the middle. The path crosses
# floor(180 degrees / wedge + 1/2 - this) sides, and 1/2 - this is far from a whole number.
const _SHARE := 0.2


## See [method StabilityFamily.cases].
func cases() -> Array[StabilityCase]:
	var found: Array[StabilityCase] = []
	for degrees in _DEGREES:
		var title := tr("A ball shot into a wedge of %s°") % NumberText.short(degrees)
		var criterion := tr("%d bounces, speed within 1e-12") % _bounces(degrees)
		var case := _case(title, criterion, _try_wedge.bind(degrees))
		if degrees < _SHARP:
			case.without_quick_form()
		found.append(case)
	return found


func _bounces(degrees: float) -> int:
	return floori(180.0 / degrees + 0.5 - _SHARE)


# The wedge opens to the right, its corner is at the origin.
func _try_wedge(_is_quick: bool, degrees: float) -> StabilityResult:
	var half := Vec2.deg_to_rad(degrees / 2.0)
	# The ball's centre can move in a wedge whose sides are one radius inside those of the wedge.
	var corner_x := _RADIUS / sin(half)
	var far := corner_x + 10.0 * _START
	var direction := Vec2.unit_degrees(180.0 - _SHARE * degrees)
	var ball := Ball.new(Vec2.new(corner_x + _START, 0.0), _RADIUS, direction.scaled(_START))
	var world := _world(
		[
			_segment(0.0, 0.0, far * cos(half), far * sin(half)),
			_segment(0.0, 0.0, far * cos(half), -far * sin(half))
		],
		[ball]
	)
	# In and out again.
	_need(world.advance(5.0))
	var lost := absf(world.velocity(0).length() / _START - 1.0)
	var figure := tr("bounces: %d, speed off by %s") % [world.impacts, NumberText.size(lost)]
	return StabilityResult.new(figure, world.impacts == _bounces(degrees) and lost <= 1e-12)
