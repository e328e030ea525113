class_name LinesShot
extends Shot
## One ball among angled lines, where each bounce multiplies the error: the number of bounces for
## which a method follows the exact path.

## Pixels. A ball farther than this from the exact path has lost it.
const LOST := 1.0

# The ends of the lines inside the box, as x, y, x, y, in pixels.
const _LINES: PackedInt32Array = [
	-220,
	-100,
	-120,
	-140,
	-60,
	-120,
	20,
	-60,
	100,
	-140,
	180,
	-90,
	230,
	-40,
	190,
	60,
	60,
	40,
	140,
	90,
	-40,
	60,
	-120,
	110,
	-230,
	40,
	-170,
	120,
	-20,
	150,
	60,
	130,
]
# In pixels per second.
const _SPEED := 400.0
# In radians on screen.
const _DIRECTION := 0.35

# The exact path; computed when it is first needed.
var _exact: ExactPath


## The only shot of its problem.
func _init() -> void:
	problem = "angled_lines"
	situation = "%d px/s" % _SPEED
	var velocity := Vec2.unit_radians(_DIRECTION).scaled(_SPEED)
	ball = Ball.new(Vec2.new(-170.0, -20.0), 10.0, velocity)
	path_seconds = 20.0


## See [method Shot.segments].
func segments() -> Array[LineSegment]:
	var found := BallInBox.walls()
	for i in range(0, _LINES.size(), 4):
		var start := Vec2.new(_LINES[i], _LINES[i + 1])
		found.append(LineSegment.new(start, Vec2.new(_LINES[i + 2], _LINES[i + 3])))
	return found


## See [method Shot.judge]: the error is 1 over the number of bounces.
func judge(case: MeasuredCase, _end: Vec2, path: PackedFloat64Array) -> void:
	var exact := exact_path()
	var frames := path.size() >> 1
	var frame := 0
	while frame < frames and _distance(exact, path, frame) <= LOST:
		frame += 1
	var time := minf(frame + 1, frames) / 60.0
	var count := bounces_until(time)
	case.error_unit = "1/bounces"
	case.error = 1.0 / maxi(count, 1)
	case.figures["bounces"] = count
	var words := "never 1 px off in" if frame == frames else "1 px off after"
	var bounces := "1 bounce" if count == 1 else "%d bounces" % count
	case.note = "%s %s, %.2f s" % [words, bounces, time]


## The exact path over [member Shot.path_seconds].
func exact_path() -> ExactPath:
	if _exact == null:
		_exact = ExactPath.new()
		Refusal.push(_exact.start(ball, segments()))
		Refusal.push(_exact.advance_to(path_seconds))
	return _exact


## The number of bounces of the exact path until [param time], in seconds.
func bounces_until(time: float) -> int:
	var count := -1
	for flight in exact_path().flights:
		if flight.start.to_float() <= time:
			count += 1
	return count


func _distance(exact: ExactPath, path: PackedFloat64Array, frame: int) -> float:
	var place := Vec2.new(path[2 * frame], path[2 * frame + 1])
	return exact.position_at((frame + 1) / 60.0).distance_to(place)
