@abstract class_name BallFlight
extends FlightCase
## The flight of one ball by one method, read after every step: where it ends, and what it takes.

const _FRAMES_PER_SECOND := 60

## What is flown.
var shot: Shot

# Where the ball was seen last: each step reads its place, as a game does that draws it.
var _x := 0.0
var _y := 0.0


## A flight of this shot in so many steps a second: 60 or a multiple of it.
func _init(of_shot: Shot, at_rate: int) -> void:
	super(of_shot.seconds, at_rate)
	shot = of_shot
	problem = shot.problem
	situation = shot.situation


func _find_error() -> void:
	var end := Vec2.new(_x, _y)
	var path: PackedFloat64Array = []
	if shot.path_seconds > 0.0:
		_clear()
		@warning_ignore("redundant_await")
		path = await _path_of(roundi(shot.path_seconds * _FRAMES_PER_SECOND))
	shot.judge(self, end, path)


# Flies once more, frame by frame: x, y after each.
func _path_of(frames: int) -> PackedFloat64Array:
	var path: PackedFloat64Array = []
	_prepare()
	for frame in frames:
		_fly(floori(float(rate) / _FRAMES_PER_SECOND))
		path.append(_x)
		path.append(_y)
	return path
