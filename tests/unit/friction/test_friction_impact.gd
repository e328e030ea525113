extends LabTest
## Impacts with friction at a segment that rests, moves or turns, against 3500 answers that were
## computed with 60 digits.

const _BAR := 4.0

var _ball := Ball.new(Vec2.new(0, 100), 20, Vec2.new(300, 400))
var _floor := LineSegment.new(Vec2.new(-900, 520), Vec2.new(900, 520))


func test_every_row_with_a_segment_at_rest_or_moving() -> void:
	for table: String in ["ball_segment_friction", "ball_moving_segment"]:
		var rows := FrictionRows.new(table)
		for row: int in rows.table.size():
			rows.judge(row, _impact(rows, row), _relative(rows, row).length())
		_assert_right(rows)


func test_every_row_with_a_segment_that_turns() -> void:
	var rows := FrictionRows.new("ball_turning_segment")
	for row: int in rows.table.size():
		var pivot := rows.table.vector(row, "cx", "cy")
		var turn := rows.table.at(row, "turn")
		var turning := TurningSegment.new(
			rows.segment(row), pivot, turn, rows.segment_velocity(row)
		)
		var longest := rows.table.at(row, "t_max")
		var impact := FrictionImpact.with_turning(
			rows.ball(row), turning, rows.bounciness(row), rows.friction(row), longest
		)
		var fastest := _relative(rows, row).length() + absf(turn) * turning.reach()
		rows.judge(row, impact, fastest)
	_assert_right(rows)


# The searched time is that of the answer and a bit more; without one, a long time.
func test_by_the_slide_grazing_impacts_and_long_ways_lose_their_digits() -> void:
	for table: String in ["ball_segment_friction", "ball_moving_segment"]:
		var rows := FrictionRows.new(table)
		for row: int in rows.table.size():
			var longest := 1.5 * rows.table.at(row, "t") if rows.table.is_hit(row) else 1e4
			var impact := FrictionImpact.with_segment_by_the_slide(
				rows.ball(row),
				rows.segment(row),
				rows.bounciness(row),
				rows.friction(row),
				maxf(longest, 1.0),
				rows.segment_velocity(row)
			)
			rows.judge(row, impact, _relative(rows, row).length())
		gut.p("by the slide, %s: %d wrong, %s" % [table, rows.wrong.size(), rows.worst])
		assert_gt(rows.wrong.size(), 0)
		assert_gt(rows.worst.largest(), 1e6)
	# In one row of very different sizes a square is too large for a double.
	assert_push_error("The normal must have length 1, but has length nan.")


func test_the_lesson_s_numbers() -> void:
	var stick := FrictionImpact.with_segment(_ball, _floor, 1.0, 0.25)
	assert_eq([stick.hit, stick.time, stick.regime], [true, 1.0, Friction.Regime.STICK])
	assert_vec2(stick.position, Vec2.new(300, 500), 0.0)
	assert_vec2(stick.normal, Vec2.new(0, -1), 0.0)
	assert_vec2(stick.velocity, Vec2.new(200, -400), 0.0)
	assert_eq(stick.spin, 10.0)
	var slips := FrictionImpact.with_segment(_ball, _floor, 1.0, 0.1)
	assert_eq(slips.regime, Friction.Regime.SLIP)
	assert_vec2(slips.velocity, Vec2.new(220, -400), 1e-13)
	assert_almost_eq(slips.spin, 8.0, 1e-14)


func test_the_ball_stays_as_it_is() -> void:
	FrictionImpact.with_segment(_ball, _floor, 1.0, 0.25)
	assert_vec2(_ball.velocity, Vec2.new(300, 400), 0.0)
	assert_eq(_ball.spin, 0.0)


func test_without_a_hit_the_ball_keeps_its_velocity_and_spin() -> void:
	_ball.velocity.y = -400
	_ball.spin = 3.0
	var impact := FrictionImpact.with_segment(_ball, _floor, 1.0, 0.25)
	assert_eq([impact.hit, impact.regime, impact.spin], [false, Friction.Regime.NONE, 3.0])
	assert_vec2(impact.velocity, Vec2.new(300, -400), 0.0)


# The lesson on platforms: -200 against +100.
func test_a_wall_that_comes_to_meet_the_ball_adds_twice_its_speed() -> void:
	var ball := Ball.new(Vec2.new(100, 0), 10, Vec2.new(-200, 0))
	var wall := LineSegment.new(Vec2.new(0, -50), Vec2.new(0, 50))
	for bounciness: float in [1.0, 0.5]:
		var impact := FrictionImpact.with_segment(ball, wall, bounciness, 0.0, Vec2.new(100, 0))
		assert_almost_eq(impact.time, 0.3, 1e-16)
		assert_vec2(impact.position, Vec2.new(40, 0), 1e-13)
		assert_vec2(impact.velocity, Vec2.new(100 + 300 * bounciness, 0), 0.0)


# Turned by a quarter, the paddle meets the ball with 100 px times 2 rad/s = 200 px/s upwards.
func test_a_paddle_meets_the_ball_as_fast_as_the_touched_point_moves() -> void:
	var paddle := LineSegment.new(Vec2.zero(), Vec2.new(0, 150))
	var ball := Ball.new(Vec2.new(100, -10), 10)
	var turning := TurningSegment.new(paddle, Vec2.zero(), -2.0)
	var impact := FrictionImpact.with_turning(ball, turning, 1.0, 0.0, 10.0)
	assert_almost_eq(impact.time, PI / 4.0, 1e-15)
	assert_vec2(impact.normal, Vec2.new(0, -1), 1e-15)
	assert_vec2(impact.velocity, Vec2.new(0, -400), 1e-12)


func test_what_moves_along_sees_the_same() -> void:
	var vectors := random_vectors(61, 600)
	var differences: PackedFloat64Array = []
	for index: int in range(0, vectors.size(), 6):
		differences.append(_difference_seen(vectors.slice(index, index + 6)))
	assert_all_at_most(differences, 1e-9)


# By how much the impacts differ in a frame of reference that moves with the last vector.
func _difference_seen(six: Array[Vec2]) -> float:
	var segment := LineSegment.new(six[0], six[1])
	var ball := Ball.new(six[2], 5, six[3], 1, 4.0)
	var here := FrictionImpact.with_segment(ball, segment, 0.7, 0.3, six[4])
	ball.velocity.add(six[5])
	var there := FrictionImpact.with_segment(ball, segment, 0.7, 0.3, six[4].plus(six[5]))
	if here.hit != there.hit or here.regime != there.regime:
		return INF
	var velocity := there.velocity.minus(six[5])
	return velocity.distance_to(here.velocity) + absf(there.spin - here.spin)


func test_what_cannot_be_used_is_an_error() -> void:
	for friction: float in [-0.1, INF, NAN]:
		assert_false(FrictionImpact.with_segment(_ball, _floor, 1.0, friction).hit)
		assert_push_error("The friction µ must be within 0..1e+152, not %s." % friction)
	assert_false(FrictionImpact.with_segment(_ball, _floor, 1.5, 0.1).hit)
	assert_push_error("The bounciness C must be within 0..1, not 1.5.")
	assert_false(FrictionImpact.with_segment(_ball, _floor, 1.0, 0.1, Vec2.new(NAN, 0)).hit)
	assert_push_error("A pivot's position and velocity must be within -1e+152..1e+152")
	assert_false(FrictionImpact.with_segment(_ball, _floor, 1.0, 0.1, Vec2.new(0, 1e151)).hit)
	assert_push_error("Distance times speed must be at most 1e+152 px²/s, not ")
	_ball.spin = INF
	assert_false(FrictionImpact.with_segment(_ball, _floor, 1.0, 0.1).hit)
	assert_push_error("A ball's spin must be finite, not inf rad/s.")
	_ball.radius = 0.0
	assert_false(FrictionImpact.with_segment(_ball, _floor, 1.0, 0.1).hit)
	assert_push_error("A ball's radius must be above 0")


func _assert_right(rows: FrictionRows) -> void:
	assert_eq(rows.wrong, PackedInt32Array())
	gut.p("worst errors: %s" % rows.worst)
	assert_all_at_most(rows.worst.values(), _BAR, str(rows.worst))


static func _impact(rows: FrictionRows, row: int) -> FrictionImpact:
	return FrictionImpact.with_segment(
		rows.ball(row),
		rows.segment(row),
		rows.bounciness(row),
		rows.friction(row),
		rows.segment_velocity(row)
	)


static func _relative(rows: FrictionRows, row: int) -> Vec2:
	return rows.ball(row).velocity.minus(rows.segment_velocity(row))
