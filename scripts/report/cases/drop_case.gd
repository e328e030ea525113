@abstract class_name DropCase
extends FlightCase
## A dropped ball by one method: its height and its energy after a minute.

# A ball with more than this times the energy of the start has blown up.
const _BLOWN_UP := 100.0

## The coefficient of restitution C.
var bounciness: float

# The latest values: pixels above the floor, and pixels per second.
var _height := 0.0
var _speed := 0.0


## A ball with this bounciness, moved in [param at_rate] steps a second.
func _init(with_bounciness: float, at_rate: int) -> void:
	super(DroppedBall.SECONDS, at_rate)
	problem = "dropped_ball"
	bounciness = with_bounciness
	situation = DroppedBall.situation_of(bounciness)


func _find_error() -> void:
	var energy := DroppedBall.energy_share(_height, _speed)
	# Not "greater": of NaN every comparison is false.
	if not absf(energy) <= _BLOWN_UP:
		error = Measurement.NO_ANSWER
		note = "blown up: more than %d times the energy of the start" % _BLOWN_UP
		return
	error = absf(_height - DroppedBall.height_after(seconds, bounciness))
	figures["height"] = _height
	figures["energy"] = energy
	note = "height %.4f px, energy %.6f of the start's" % [_height, energy]
