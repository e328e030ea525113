class_name BallInBoxProblem
extends ReportProblem
## The second problem: one elastic ball in a box, for each method, speed, length and step.

## The speeds of the ball, in pixels per second.
const SPEEDS: PackedFloat64Array = [300.0, 3000.0, 30000.0]
## The simulated time of the short flight, in seconds.
const SHORT := 10.0
## The simulated time of the long flight, in seconds.
const LONG := 100.0
## The event world, asked in each frame.
const EVENT_WORLD := "event world"
## The same with a loop that computes the straight flights itself.
const FOLLOWED := "event world, flights followed"
## The same in one call for the whole flight.
const ONE_CALL := "event world, one call"


func _init() -> void:
	id = "ball_in_box"
	champion = EVENT_WORLD
	title = "One ball in a box"
	question = (
		"A ball of 10 px radius in a box of 600 x 400 px, without gravity, C = 1, read after each"
		+ " step. The error is the distance of its end from the exact position, known by unfolding."
	)


## See [method ReportProblem.cases].
func cases(is_quick: bool) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for shot in shots():
		found.append(OneCallFlight.new(ONE_CALL, shot))
		for rate in rates(shot, is_quick):
			found.append(EventFlight.new(EventFlight.Form.WALLS, EVENT_WORLD, shot, rate))
			found.append(FollowedFlight.new(EventFlight.Form.WALLS, FOLLOWED, shot, rate))
			found.append(
				EventFlight.new(EventFlight.Form.GRID, "event world, walls as segments", shot, rate)
			)
			for way in SteppedFlight.METHODS:
				found.append(SteppedFlight.new(way, shot, rate))
	return found


## See [method ReportProblem.ceilings]: what a call in each frame of every flight takes.
func ceilings() -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for shot in shots():
		found.append(EmptyCall.new(shot, 60))
	return found


## All flights: the short ones, then the long ones.
static func shots() -> Array[Shot]:
	var found: Array[Shot] = []
	for seconds: float in [SHORT, LONG]:
		for speed in SPEEDS:
			found.append(BoxShot.new(speed, seconds))
	return found


## The numbers of steps in a second that are measured: few if a flight would take too long.
static func rates(shot: Shot, is_quick: bool) -> PackedInt32Array:
	if shot.seconds == LONG:
		return [60] if is_quick else [60, 240, 960]
	return [60, 240] if is_quick else [60, 240, 960, 3840]
