@abstract class_name ShotFlight
extends FlightCase
## The flight of one ball by one method, read after every step: its end, and its run time.

const _FRAMES_PER_SECOND := 60

## The shot that is flown.
var shot: Shot

# The latest position of the ball. Each step reads it, as a game does to draw the ball.
var _x := 0.0
var _y := 0.0


## A flight of this shot with [param at_rate] steps a second: 60 or a multiple of it.
func _init(of_shot: Shot, at_rate: int) -> void:
	super(of_shot.seconds, at_rate)
	shot = of_shot
	problem = shot.problem
	situation = shot.situation


## See [method MeasuredCase.run_once]. A run of a shot that goes on begins at the end of the last
## run.
func run_once() -> void:
	if not shot.goes_on:
		@warning_ignore("redundant_await")
		await super()
		return
	if runs() == 0:
		@warning_ignore("redundant_await")
		await _find_error()
	if not refusal:
		@warning_ignore("redundant_await")
		await _fly(steps)
	keep_run(_spent / seconds)


func _find_error() -> void:
	var end := Vec2.new(_x, _y)
	var path: PackedFloat64Array = []
	if shot.path_seconds > 0.0:
		@warning_ignore("redundant_await")
		await _set_up()
		for frame in roundi(shot.path_seconds * _FRAMES_PER_SECOND):
			if refusal:
				return
			@warning_ignore("redundant_await")
			await _fly(floori(float(rate) / _FRAMES_PER_SECOND))
			path.append(_x)
			path.append(_y)
	shot.judge(self, end, path)
