class_name BallInBoxProblem
extends ReportProblem
## The second problem: one elastic ball in a box, for each method, speed, length and step.

## Pixels per second.
const SPEEDS: PackedFloat64Array = [300.0, 3000.0, 30000.0]
## The short flight.
const SHORT := 10.0
## The long flight.
const LONG := 100.0


func _init() -> void:
	id = "ball_in_box"
	title = "One ball in a box"
	question = (
		"A ball of 10 px radius in a box of 600 x 400 px, without gravity, C = 1, read after each"
		+ " step. The error is how far it ends from the exact place, which unfolding tells."
	)


## See [method ReportProblem.cases].
func cases(is_quick: bool) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for speed in SPEEDS:
		for way in SteppedBoxFlight.METHODS:
			for rate: int in [60, 240] if is_quick else [60, 240, 960, 3840]:
				found.append(SteppedBoxFlight.new(way, speed, SHORT, rate))
			for rate: int in [60] if is_quick else [60, 240, 960]:
				found.append(SteppedBoxFlight.new(way, speed, LONG, rate))
	return found
