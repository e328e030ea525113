extends LabTest
## Impacts of two balls with friction, against 1500 answers that were computed with 60 digits.

const _BAR := 4.0

var _table := MotionTable.new("ball_ball_friction")


func test_every_row_is_answered_to_the_last_bits() -> void:
	var worst := WorstErrors.new()
	var wrong: PackedInt32Array = []
	for row: int in _table.size():
		var impact := BallFrictionImpact.between(
			_ball(row, "1"), _ball(row, "2"), _bounciness(row), _friction(row)
		)
		_judge(row, impact, worst, wrong)
	assert_eq(wrong, PackedInt32Array())
	gut.p("worst errors, two balls: %s" % worst)
	assert_all_at_most(worst.values(), _BAR, str(worst))


func test_by_the_slide_digits_are_lost() -> void:
	var worst := WorstErrors.new()
	var wrong: PackedInt32Array = []
	for row: int in _table.size():
		var longest := 1.5 * _table.at(row, "t") if _table.is_hit(row) else 1e4
		var impact := BallFrictionImpact.between_by_the_slide(
			_ball(row, "1"), _ball(row, "2"), _bounciness(row), _friction(row), maxf(longest, 1.0)
		)
		_judge(row, impact, worst, wrong)
	gut.p("by the slide: %d wrong, %s" % [wrong.size(), worst])
	assert_gt(worst.largest(), 50.0)


func test_balls_that_move_apart_do_not_meet_and_stay_as_they_are() -> void:
	var one := Ball.new(Vec2.new(15, 0), 10, Vec2.new(1, 0), 1.0, 2.0)
	var impact := BallFrictionImpact.between(one, Ball.new(Vec2.zero(), 10), 1.0, 0.2)
	assert_eq([impact.hit, impact.spin_one, impact.spin_other], [false, 2.0, 0.0])
	assert_vec2(impact.velocity_one, Vec2.new(1, 0), 0.0)


func test_the_balls_stay_as_they_are() -> void:
	var one := Ball.new(Vec2.new(50, 3), 10, Vec2.new(-1, 0))
	var other := Ball.new(Vec2.zero(), 10)
	assert_true(BallFrictionImpact.between(one, other, 1.0, 0.2).hit)
	assert_vec2(one.velocity, Vec2.new(-1, 0), 0.0)
	assert_eq([one.spin, other.spin], [0.0, 0.0])


func test_what_cannot_be_used_is_an_error() -> void:
	var good := Ball.new(Vec2.new(50, 0), 10, Vec2.new(-9, 0))
	var bad := Ball.new(Vec2.zero(), -1.0)
	assert_false(BallFrictionImpact.between(good, bad, 1.0, 0.2).hit)
	assert_push_error("A ball's radius must be above 0")
	bad.radius = 1e152
	assert_false(BallFrictionImpact.between(good, bad, 1.0, 0.2).hit)
	assert_push_error("Distance times speed must be at most 1e+152 px²/s, not ")
	bad.radius = 1.0
	assert_false(BallFrictionImpact.between(good, bad, 1.0, -0.2).hit)
	assert_push_error("The friction µ must be within 0..1e+152, not -0.2.")


func _judge(
	row: int, impact: BallFrictionImpact, worst: WorstErrors, wrong: PackedInt32Array
) -> void:
	if impact.hit != _table.is_hit(row) or impact.regime != int(_table.at(row, "regime")):
		wrong.append(row)
		return
	var family := _table.family(row)
	_judge_ball(row, impact.velocity_one, impact.spin_one, "1", worst)
	_judge_ball(row, impact.velocity_other, impact.spin_other, "2", worst)
	if impact.hit:
		worst.note(family, _table.error(row, impact.time, "t"))
		worst.note(family, _normal_error(row, impact.normal))


func _judge_ball(row: int, velocity: Vec2, spin: float, number: String, worst: WorstErrors) -> void:
	var wanted := _table.vector(row, "v%sx_after" % number, "v%sy_after" % number)
	var error := _table.velocity_error(row, velocity, wanted, "condition_v" + number)
	worst.note(_table.family(row), error)
	var column := "spin%s_after" % number
	error = _table.error(row, spin, column, "condition_spin" + number)
	worst.note(_table.family(row), error)


func _normal_error(row: int, normal: Vec2) -> float:
	var one := _ball(row, "1")
	var other := _ball(row, "2")
	var lengths: PackedFloat64Array = [
		one.velocity.minus(other.velocity).length(),
		one.position.length(),
		other.position.length(),
	]
	return _table.normal_error(row, normal, one.radius + other.radius, lengths)


func _ball(row: int, number: String) -> Ball:
	var place := _table.vector(row, "p%sx" % number, "p%sy" % number)
	var velocity := _table.vector(row, "v%sx" % number, "v%sy" % number)
	var spin := _table.at(row, "spin" + number)
	return Ball.new(
		place, _table.at(row, "r" + number), velocity, _table.at(row, "m" + number), spin
	)


func _bounciness(row: int) -> float:
	return _table.at(row, "restitution")


func _friction(row: int) -> float:
	return _table.at(row, "friction")
