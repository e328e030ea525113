class_name RefusalStability
extends StabilityFamily
## A world refuses what it cannot do: it returns one sentence with the value and what is allowed,
## and nothing has changed.

# Values that no size can have.
const _NO_SIZES: PackedFloat64Array = [0.0, -1.0, NAN, INF]
const _NOT_FINITE: PackedFloat64Array = [NAN, INF, -INF]


## See [method StabilityFamily.cases].
func cases() -> Array[StabilityCase]:
	return [
		_refused(tr("NaN or infinity as a ball's place"), _ball_places),
		_refused(tr("NaN or infinity as a ball's velocity"), _ball_velocities),
		_refused(tr("A ball's radius of 0, -1, NaN, infinity"), _radii),
		_refused(tr("A ball's mass of 0, -1, NaN, infinity"), _masses),
		_refused(tr("NaN or infinity as a segment's end"), _segment_ends),
		_refused(tr("A segment of length 0"), _short_segments),
		_refused(tr("C outside 0..1"), _bouncinesses),
		_refused(tr("NaN or infinity as gravity"), _gravities),
		_refused(tr("Seconds below 0, NaN, infinity"), _durations),
		_refused(tr("A time that is over, NaN, infinity"), _moments),
		_refused(tr("Walls that leave no room, NaN, infinity"), _walls),
		_refused(tr("The index of a ball or segment that is not there"), _indices),
	]


func _refused(title: String, trials: Callable) -> StabilityCase:
	var criterion := tr("a sentence with the value and what is allowed; nothing has changed")
	return _case(title, criterion, _try.bind(trials))


# [param trials] takes a world and returns its answers, each with the words that it must contain.
func _try(_is_quick: bool, trials: Callable) -> StabilityResult:
	var world := _world(
		[_segment(-300.0, 90.0, 300.0, 120.0), _segment(300.0, 120.0, 200.0, -400.0)],
		[_ball(0.0, 0.0, 30.0, 50.0, 10.0), _ball(60.0, -20.0, -30.0, 10.0, 5.0)]
	)
	_need(world.set_gravity(Vec2.new(0.0, 100.0)))
	_need(world.advance(1.5))
	var before := _all_of(world)
	var answers: Array[PackedStringArray] = trials.call(world)
	var wrong: PackedStringArray = []
	for answer in answers:
		for word in answer.slice(1):
			if not answer[0].contains(word):
				wrong.append(tr("“%s” without “%s”") % [answer[0], word])
	if _all_of(world) != before:
		wrong.append(tr("the world has changed"))
	if wrong:
		return StabilityResult.new("; ".join(wrong), false)
	return StabilityResult.new(answers[-1][0], true)


# The state of the whole world, to the last bit.
func _all_of(world: EventWorld) -> Array:
	var kept := world.snapshot()
	var counts := [kept.impacts, kept.contents, kept.count_from, kept.counted_impacts]
	return [kept.time, kept.time_low, counts, kept.arrays]


func _ball_places(world: EventWorld) -> Array[PackedStringArray]:
	var answers: Array[PackedStringArray] = []
	for value in _NOT_FINITE:
		var answer := world.add_ball(Ball.new(Vec2.new(1.0, value), 5.0))
		answers.append([answer, str(value), "finite"] as PackedStringArray)
		answer = world.change_ball(0, Ball.new(Vec2.new(value, 1.0), 5.0))
		answers.append([answer, str(value), "finite"] as PackedStringArray)
	return answers


func _ball_velocities(world: EventWorld) -> Array[PackedStringArray]:
	var answers: Array[PackedStringArray] = []
	for value in _NOT_FINITE:
		var answer := world.add_ball(Ball.new(Vec2.new(), 5.0, Vec2.new(1.0, value)))
		answers.append([answer, str(value), "finite"] as PackedStringArray)
		answer = world.set_balls([Ball.new(Vec2.new(), 5.0, Vec2.new(value, 1.0))])
		answers.append([answer, str(value), "finite"] as PackedStringArray)
	return answers


func _radii(world: EventWorld) -> Array[PackedStringArray]:
	var answers: Array[PackedStringArray] = []
	for value in _NO_SIZES:
		var answer := world.add_ball(Ball.new(Vec2.new(), value))
		answers.append([answer, str(value), "above 0 and finite"] as PackedStringArray)
		answer = world.change_ball(1, Ball.new(Vec2.new(), value))
		answers.append([answer, str(value), "above 0 and finite"] as PackedStringArray)
	return answers


func _masses(world: EventWorld) -> Array[PackedStringArray]:
	var answers: Array[PackedStringArray] = []
	for value in _NO_SIZES:
		var answer := world.add_ball(Ball.new(Vec2.new(), 5.0, Vec2.new(), value))
		answers.append([answer, str(value), "above 0 and finite"] as PackedStringArray)
	return answers


func _segment_ends(world: EventWorld) -> Array[PackedStringArray]:
	var answers: Array[PackedStringArray] = []
	for value in _NOT_FINITE:
		var answer := world.add_segment(_segment(0.0, 0.0, value, 1.0))
		answers.append([answer, str(value), "finite"] as PackedStringArray)
		answer = world.move_segment(1, _segment(0.0, value, 7.0, 1.0))
		answers.append([answer, str(value), "finite"] as PackedStringArray)
	return answers


func _short_segments(world: EventWorld) -> Array[PackedStringArray]:
	var dot := _segment(3.0, 4.0, 3.0, 4.0)
	var place := str(dot.start)
	return [
		[world.add_segment(dot), place, "longer than 0"],
		[world.move_segment(0, dot), place, "longer than 0"],
		[world.set_segments([_segment(0.0, 0.0, 1.0, 1.0), dot]), place, "longer than 0"],
	]


func _bouncinesses(world: EventWorld) -> Array[PackedStringArray]:
	var answers: Array[PackedStringArray] = []
	for value: float in [-1e-9, 1.0 + 1e-9, -INF, INF, NAN]:
		answers.append([world.set_bounciness(value), str(value), "0..1"] as PackedStringArray)
	return answers


func _gravities(world: EventWorld) -> Array[PackedStringArray]:
	var answers: Array[PackedStringArray] = []
	for value in _NOT_FINITE:
		var answer := world.set_gravity(Vec2.new(value, 0.0))
		answers.append([answer, str(value), "within"] as PackedStringArray)
	return answers


func _durations(world: EventWorld) -> Array[PackedStringArray]:
	var answers: Array[PackedStringArray] = []
	for value: float in [-1e-9, NAN, INF, -INF]:
		answers.append([world.advance(value), str(value), "0"] as PackedStringArray)
	return answers


func _moments(world: EventWorld) -> Array[PackedStringArray]:
	var answers: Array[PackedStringArray] = []
	for value: float in [1.4, NAN, INF, -INF]:
		answers.append([world.advance_to(value), str(value), "1.5"] as PackedStringArray)
	return answers


func _walls(world: EventWorld) -> Array[PackedStringArray]:
	var answers: Array[PackedStringArray] = []
	for value: float in [-500.0, NAN, INF]:
		var corner := Vec2.new(500.0, value)
		var answer := world.set_walls(Vec2.new(-500.0, -500.0), corner)
		answers.append([answer, str(corner), "within"] as PackedStringArray)
	return answers


func _indices(world: EventWorld) -> Array[PackedStringArray]:
	var answers: Array[PackedStringArray] = []
	for value: int in [-1, 2, 1000]:
		answers.append([world.remove_ball(value), str(value)] as PackedStringArray)
		answers.append([world.change_ball(value, _ball(0, 0, 0, 0, 1)), str(value)])
		answers.append([world.remove_segment(value), str(value)] as PackedStringArray)
		var moved := _segment(0.0, 0.0, 1.0, 1.0)
		answers.append([world.move_segment(value, moved), str(value)] as PackedStringArray)
	return answers
