@abstract class_name BoxFlight
extends FlightCase
## The flight of one ball in the box by one method, read after every step: where it ends, and what
## it takes.

## Pixels per second.
var speed: float

# Where the ball was seen last: each step reads its place, as a game does that draws it.
var _x := 0.0
var _y := 0.0


## A flight at this speed, of so many seconds and steps a second.
func _init(at_speed: float, for_seconds: float, at_rate: int) -> void:
	super(for_seconds, at_rate)
	problem = "ball_in_box"
	speed = at_speed
	situation = situation_of(speed, seconds)


## How the situation is named in tables.
static func situation_of(at_speed: float, for_seconds: float) -> String:
	return "%d px/s, %d s" % [at_speed, for_seconds]


func _find_error() -> void:
	error = BallInBox.error_of(Vec2.new(_x, _y), speed, seconds)
	if error == Measurement.NO_ANSWER:
		note = "the ball has left the box"
