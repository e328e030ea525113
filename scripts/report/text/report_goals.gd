class_name ReportGoals
extends RefCounted
## The goals of the event world, as ratios within one run, and whether the measurements reach them.

## The ways to use the event world that are judged, with their words for the table.
const WAYS: Dictionary[String, String] = {
	BallInBoxProblem.ONE_CALL: "in one call for the whole flight",
	BallInBoxProblem.EVENT_WORLD: "called each frame",
	BallInBoxProblem.FOLLOWED: "flights followed by the caller",
}
## The least ratio to the run time of move_and_collide at 60 Hz, by speed in px/s, for the world
## that is called each frame. There is a ceiling for it: see [EmptyCall].
const CALLED_RATIOS: Dictionary[float, float] = {300.0: 1.5, 3000.0: 1.5, 30000.0: 1.8}
## The same in the other ways. At the highest speed the ball bounces more than once a frame.
const BOX_RATIOS: Dictionary[float, float] = {300.0: 2.5, 3000.0: 2.5, 30000.0: 1.5}
## The largest error after the long flight in the box, in pixels.
const BOX_ERROR := 1e-9
## The largest growth exponent of the run time of a frame with the number of segments.
const GROWTH := 0.05
## The least ratio to the run time of the engine's concave shape.
const SEGMENTS_RATIO := 3.0
## The least number of segments at which that ratio is judged.
const SEGMENTS_FROM := 1024
## The number of balls that is judged.
const CROWD := 1000
## The least ratio to the run time of RigidBody2D, by its rate.
const CROWD_RATIOS: Dictionary[int, float] = {60: 1.0, 240: 3.0}
## The largest drift of the energy of all balls, as a fraction of it.
const CROWD_DRIFT := 1e-12
## The deepest overlap of two balls, in pixels.
const CROWD_OVERLAP := 1e-9


## All goals; each is judged if this run has measured what it needs.
static func of(measurements: Array[Measurement]) -> Array[ReportGoal]:
	var box := Measurement.of_problem("ball_in_box", measurements)
	var found: Array[ReportGoal] = [_frontier(box)]
	for method: String in WAYS:
		for speed in BOX_RATIOS:
			found.append(_box_ratio(box, speed, method))
	found.append(_box_error(box))
	found.append_array(_segments(Measurement.of_problem("many_segments", measurements)))
	found.append_array(_crowd(Measurement.of_problem("many_balls", measurements)))
	return found


static func _frontier(rows: Array[Measurement]) -> ReportGoal:
	var situations := ProblemPicture.situations_in(rows)
	var count := 0
	for situation in situations:
		for row in Frontier.of(ProblemPicture.in_situation(situation, rows)):
			if row.method.begins_with(BallInBoxProblem.EVENT_WORLD):
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


static func _box_ratio(rows: Array[Measurement], speed: float, method: String) -> ReportGoal:
	var is_called := method == BallInBoxProblem.EVENT_WORLD
	var least := INF
	var ceiling := INF
	for shot in BallInBoxProblem.shots():
		if shot.situation.begins_with("%d px/s," % speed):
			for form: String in ["segments", "concave shape"]:
				var baseline := _time(rows, "move_and_collide, " + form, shot.situation)
				least = minf(least, baseline / _time(rows, method, shot.situation))
				ceiling = minf(ceiling, baseline / _time(rows, EmptyCall.METHOD, shot.situation))
	var bound := CALLED_RATIOS[speed] if is_called else BOX_RATIOS[speed]
	var goal := ReportGoal.new(
		(
			"one ball in the box, %d px/s: times faster than move_and_collide at 60 Hz, %s"
			% [speed, WAYS[method]]
		),
		"at least %s" % bound
	)
	goal.at_least(least if is_finite(least) else NAN, bound)
	if is_called and goal.is_judged and is_finite(ceiling):
		goal.measured += " (%s: %s)" % [EmptyCall.METHOD, FigureText.short(ceiling)]
	return goal


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


static func _segments(rows: Array[Measurement]) -> Array[ReportGoal]:
	var growth := ReportGoal.new(
		"one ball among 64 to 16384 segments: growth exponent of the event world's frame",
		"at most %s" % GROWTH
	)
	growth.at_most(ManySegmentsProblem.growth(ManySegmentsProblem.GRID, rows), GROWTH)
	return [
		growth,
		_segments_ratio(rows, ManySegmentsProblem.GRID, BallInBoxProblem.EVENT_WORLD),
		_segments_ratio(rows, BallInBoxProblem.FOLLOWED, BallInBoxProblem.FOLLOWED),
	]


static func _segments_ratio(rows: Array[Measurement], method: String, way: String) -> ReportGoal:
	var least := INF
	for count in ManySegmentsProblem.COUNTS:
		if count >= SEGMENTS_FROM:
			var own := ManySegmentsProblem.time_of(method, count, rows)
			var baseline := "move_and_collide, concave shape"
			least = minf(least, ManySegmentsProblem.time_of(baseline, count, rows) / own)
	var goal := (
		ReportGoal
		. new(
			(
				"one ball among 1024 and 16384 segments: times faster a frame than the concave shape, %s"
				% WAYS[way]
			),
			"at least %s" % SEGMENTS_RATIO
		)
	)
	return goal.at_least(least if is_finite(least) else NAN, SEGMENTS_RATIO)


static func _crowd(rows: Array[Measurement]) -> Array[ReportGoal]:
	var situation := CrowdFlight.situation_of(CROWD)
	var own := _row(rows, EventCrowd.METHOD, situation, 60)
	var found: Array[ReportGoal] = []
	for rate in CROWD_RATIOS:
		var baseline := _row(rows, "RigidBody2D", situation, rate)
		var bound := CROWD_RATIOS[rate]
		var goal := ReportGoal.new(
			"%d balls: times faster than RigidBody2D at %d Hz" % [CROWD, rate],
			"at least %s" % bound
		)
		found.append(
			goal.at_least(
				baseline.run_time_us / own.run_time_us if own and baseline else NAN, bound
			)
		)
	var drift := ReportGoal.new("%d balls: drift of the energy" % CROWD, "at most 1e-12")
	var overlap := ReportGoal.new("%d balls: worst overlap, px" % CROWD, "at most 1e-9")
	var energy_drift: float = own.figures.get("energy drift", INF) if own else NAN
	found.append(drift.at_most(energy_drift, CROWD_DRIFT))
	found.append(overlap.at_most(own.error if own else NAN, CROWD_OVERLAP))
	return found


# The measurement of a method at a rate; null if there is none.
static func _row(
	rows: Array[Measurement], method: String, situation: String, rate: int
) -> Measurement:
	for row in rows:
		if row.method == method and row.situation == situation and row.tuning == "%d Hz" % rate:
			return row
	return null


# The run time of a method at 60 Hz, or in one call; NaN if it was not measured.
static func _time(rows: Array[Measurement], method: String, situation: String) -> float:
	for row in ProblemPicture.in_situation(situation, rows):
		if row.method == method and row.tuning in ["60 Hz", OneCallFlight.TUNING]:
			return row.run_time_us
	return NAN
