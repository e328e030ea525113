class_name ReportGoals
extends RefCounted
## What the event world has to reach, as ratios of one run, and what the measurements say of it.

## How many times faster than move_and_collide at 60 Hz, by speed in px/s. At the last the ball
## bounces more than once a frame.
const BOX_RATIOS: Dictionary[float, float] = {300.0: 2.5, 3000.0: 2.5, 30000.0: 1.5}
## Pixels after the long flight in the box.
const BOX_ERROR := 1e-9


## Every goal, judged where this run has measured what it needs.
static func of(measurements: Array[Measurement]) -> Array[ReportGoal]:
	var box := ReportText.of_problem("ball_in_box", measurements)
	var found: Array[ReportGoal] = [_frontier(box)]
	for speed in BOX_RATIOS:
		found.append(_box_ratio(box, speed))
	found.append(_box_error(box))
	return found


static func _frontier(rows: Array[Measurement]) -> ReportGoal:
	var situations := ProblemPicture.situations_in(rows)
	var count := 0
	for situation in situations:
		for row in Frontier.of(ProblemPicture.in_situation(situation, rows)):
			if row.method == BallInBoxProblem.EVENT_WORLD:
				count += 1
				break
	var goal := ReportGoal.new(
		"one ball in the box: situations with the event world on the frontier", "all of them"
	)
	if not situations.is_empty():
		goal.at_least(count, situations.size())
	if goal.is_judged:
		goal.measured = "%d of %d" % [count, situations.size()]
	return goal


static func _box_ratio(rows: Array[Measurement], speed: float) -> ReportGoal:
	var least := INF
	for shot in BallInBoxProblem.shots():
		if shot.situation.begins_with("%d px/s," % speed):
			for form: String in ["segments", "concave shape"]:
				var peer := _time(rows, "move_and_collide, " + form, shot.situation)
				least = minf(
					least, peer / _time(rows, BallInBoxProblem.EVENT_WORLD, shot.situation)
				)
	var bound := BOX_RATIOS[speed]
	var goal := ReportGoal.new(
		"one ball in the box, %d px/s: times faster than move_and_collide, both at 60 Hz" % speed,
		"at least %s" % bound
	)
	return goal.at_least(least if is_finite(least) else NAN, bound)


static func _box_error(rows: Array[Measurement]) -> ReportGoal:
	var worst := NAN
	for speed in BallInBoxProblem.SPEEDS:
		var situation := BoxShot.situation_of(speed, BallInBoxProblem.LONG)
		for row in ProblemPicture.in_situation(situation, rows):
			if row.method == BallInBoxProblem.EVENT_WORLD:
				worst = row.error if is_nan(worst) else maxf(worst, row.error)
	var goal := ReportGoal.new(
		"one ball in the box: error of the event world after 100 s, px", "at most 1e-9"
	)
	return goal.at_most(worst, BOX_ERROR)


# The run time of a method at 60 Hz; NaN where it was not measured.
static func _time(rows: Array[Measurement], method: String, situation: String) -> float:
	for row in rows:
		if row.method == method and row.situation == situation and row.tuning == "60 Hz":
			return row.run_time_us
	return NAN
