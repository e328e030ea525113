class_name BallRace
extends RefCounted
## The balls of a state: the one with the friction µ, one without friction, one that rolls from the
## start, and that of the mistake. Computed once for each change.

# Where nothing moves, time runs so many seconds.
const _END_AT_REST := 1.0
# The ball of a mistake is waited for so many times as long as the right one.
const _LONGEST_WAIT := 2.5

## The ball with the friction µ.
var ball: RacingBall
## The one without friction.
var sliding: RacingBall
## The one that rolls from the start.
var rolling: RacingBall
## The run of the mistake that is switched on; null for none.
var wrong: WrongRun
## What becomes of the ball.
var run_case: SlideAndRollModel.Case

var _length: float


## Those of [param model] as it is now.
func _init(model: SlideAndRollModel) -> void:
	ball = model.ball()
	sliding = model.sliding_ball()
	rolling = model.rolling_ball()
	wrong = model.wrong_run(model.mistake)
	run_case = model.run_case(ball)
	_length = model.segment().length()


## Whether the ball comes to the end of the line.
func arrives() -> bool:
	return ball.end_time < INF


## The ball that runs on the line itself at [param step] of the explanation.
func shown_ball(step: int) -> RacingBall:
	return sliding if step < SlideAndRollModel.Step.SLIP else ball


## Until when time runs at [param step], in seconds.
func end(step: int) -> float:
	var last := shown_ball(step).end_time
	if step >= SlideAndRollModel.Step.RACE:
		last = maxf(maxf(last, sliding.end_time), rolling.end_time)
	if last == INF:
		return _END_AT_REST
	return maxf(last, _end_of_wrong()) if step >= SlideAndRollModel.Step.ROLL else last


# When the ball of the mistake is at the end, or stands still.
func _end_of_wrong() -> float:
	if not wrong:
		return 0.0
	var seconds := wrong.change if wrong.stops() else INF
	return minf(minf(seconds, wrong.time_to(_length)), _LONGEST_WAIT * ball.end_time)


## How far the ball of the mistake is ahead of the right one when that is at the end of the line, in
## pixels; below 0 where it is behind.
func lead_of_wrong() -> float:
	return wrong.distance_after(ball.end_time) - _length
