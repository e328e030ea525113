class_name BoxShot
extends Shot
## A flight of the ball in the box; see [BallInBox]. The error is that of the last position.

var _speed: float


## A flight at [param speed] pixels per second for [param for_seconds].
func _init(speed: float, for_seconds: float) -> void:
	problem = "ball_in_box"
	situation = situation_of(speed, for_seconds)
	ball = BallInBox.ball(speed)
	seconds = for_seconds
	_speed = speed


## See [method Shot.segments].
func segments() -> Array[LineSegment]:
	return BallInBox.walls()


## The name of the situation in tables.
static func situation_of(speed: float, for_seconds: float) -> String:
	return "%d px/s, %d s" % [speed, for_seconds]


## See [method Shot.judge].
func judge(case: MeasuredCase, end: Vec2, _path: PackedFloat64Array) -> void:
	case.error = BallInBox.error_of(end, _speed, seconds)
	if case.error == Measurement.NO_ANSWER:
		case.note = "the ball has left the box"
