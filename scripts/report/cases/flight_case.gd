@abstract class_name FlightCase
extends MeasuredCase
## A flight of balls over some simulated seconds, in equal steps, each of which is read: what it
## takes, and how wrong it ends.

# Microseconds. A flight is flown so often that a run takes at least this, because the clock counts
# whole microseconds.
const _SHORTEST_RUN := 2000.0

## How long the flight is.
var seconds: float
## Steps a second.
var rate: int
## How many steps the flight has.
var steps: int
## Seconds of one step.
var step_seconds: float

# Microseconds that the steps of the latest _fly have taken.
var _spent := 0.0
var _is_set_up := false


## A flight of so many seconds and steps a second.
func _init(for_seconds: float, at_rate: int) -> void:
	seconds = for_seconds
	rate = at_rate
	steps = roundi(seconds * rate)
	step_seconds = 1.0 / rate
	tuning = "%d Hz" % rate


## See [method MeasuredCase.run_once]: microseconds per simulated second.
func run_once() -> void:
	var flights := 0
	var spent := 0.0
	while spent < _SHORTEST_RUN and not refusal:
		@warning_ignore("redundant_await")
		await _set_up_and_fly(steps)
		spent += _spent
		flights += 1
		if runs() == 0 and flights == 1 and not refusal:
			@warning_ignore("redundant_await")
			await _find_error()
		_tear_down()
	keep_run(spent / maxi(flights, 1) / seconds)


## See [method MeasuredCase.finish].
func finish() -> void:
	_tear_down()


func _set_up() -> void:
	_tear_down()
	@warning_ignore("redundant_await")
	await _prepare()
	_is_set_up = true


# Without a flight where a world has refused something before.
func _set_up_and_fly(count: int) -> void:
	@warning_ignore("redundant_await")
	await _set_up()
	if not refusal:
		@warning_ignore("redundant_await")
		await _fly(count)


func _tear_down() -> void:
	if _is_set_up:
		_clear()
	_is_set_up = false


## Puts everything to the start; takes no part of the time, and may have to be awaited.
@abstract func _prepare() -> void

## Makes so many steps, reads after each where things are, and sets how long it took; may have to
## be awaited.
@abstract func _fly(count: int) -> void

## Finds how wrong the end is, once; may have to be awaited.
@abstract func _find_error() -> void


## Removes what [method _prepare] has made.
func _clear() -> void:
	pass
