@abstract class_name FlightCase
extends MeasuredCase
## A flight of balls over some simulated seconds, in equal steps with a reading after each: its run
## time, and its error at the end.

# Microseconds. A flight is repeated until a run takes at least this, because the clock counts whole
# microseconds.
const _SHORTEST_RUN := 2000.0

## The simulated time of the flight, in seconds.
var seconds: float
## The number of steps in a second.
var rate: int
## The number of steps of the flight.
var steps: int
## The time of one step, in seconds.
var step_seconds: float

# The run time of the steps of the latest _fly, in microseconds.
var _spent := 0.0
var _is_set_up := false


## A flight of [param for_seconds], with [param at_rate] steps a second.
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


## Sets everything to the start. Its time is not measured; it may have to be awaited.
@abstract func _prepare() -> void

## Makes [param count] steps, reads all positions after each, and stores the run time; may have to
## be awaited.
@abstract func _fly(count: int) -> void

## Finds the error at the end; called once. May have to be awaited.
@abstract func _find_error() -> void


## Removes what [method _prepare] has made.
func _clear() -> void:
	pass
