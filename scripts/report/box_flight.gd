@abstract class_name BoxFlight
extends MeasuredCase
## The flight of one ball in the box by one method, read after every step: where it ends, and what
## it takes.

# Microseconds. A flight is flown so often that a run takes at least this, because the clock counts
# whole microseconds.
const _SHORTEST_RUN := 2000.0

## Pixels per second.
var speed: float
## How long the flight is.
var seconds: float
## Steps a second.
var rate: int
## How many steps the flight has.
var steps: int
## Seconds of one step.
var step_seconds: float

# Where the ball was seen last: each step reads its place, as a game does that draws it.
var _x := 0.0
var _y := 0.0
# Microseconds that the steps of the latest _fly have taken.
var _spent := 0.0


## A flight of so many seconds and steps a second.
func _init(at_speed: float, for_seconds: float, at_rate: int) -> void:
	problem = "ball_in_box"
	speed = at_speed
	seconds = for_seconds
	rate = at_rate
	steps = roundi(seconds * rate)
	step_seconds = 1.0 / rate
	situation = situation_of(speed, seconds)
	tuning = "%d Hz" % rate


## How the situation is named in tables.
static func situation_of(at_speed: float, for_seconds: float) -> String:
	return "%d px/s, %d s" % [at_speed, for_seconds]


## See [method MeasuredCase.run_once].
func run_once() -> void:
	var flights := 0
	var spent := 0.0
	while spent < _SHORTEST_RUN:
		_prepare()
		@warning_ignore("redundant_await")
		await _fly(steps)
		_clear()
		spent += _spent
		flights += 1
	if runs() == 0:
		_find_error()
	keep_run(spent / flights / seconds)


## Puts everything to the start; takes no part of the time.
@abstract func _prepare() -> void

## Makes so many steps, reads the place after each, and sets how long it took; may have to be
## awaited.
@abstract func _fly(count: int) -> void


## Removes what [method _prepare] has made.
func _clear() -> void:
	pass


func _find_error() -> void:
	error = BallInBox.error_of(Vec2.new(_x, _y), speed, seconds)
	if error == Measurement.NO_ANSWER:
		note = "the ball has left the box"
