extends LabTest
## A ball that slides and rolls on a line or belt, against the reference table.

const _BAR := 4.0

var _table := MotionTable.new("incline")


func test_every_row_is_answered_to_the_last_bits() -> void:
	var worst := WorstErrors.new()
	var wrong: PackedInt32Array = []
	for row: int in _table.size():
		var run := _incline(row).run(
			_table.at(row, "r"),
			_table.at(row, "x0"),
			_table.at(row, "v0"),
			_table.at(row, "spin0"),
			_table.at(row, "t_max")
		)
		_judge(row, run, worst, wrong)
	assert_eq(wrong, PackedInt32Array())
	gut.p("worst errors, incline: %s" % worst)
	assert_all_at_most(worst.values(), _BAR, str(worst))


func _judge(row: int, run: InclineRun, worst: WorstErrors, wrong: PackedInt32Array) -> void:
	# 0, 2 and 3 in the file are no end, the start and the end.
	var leaves: float = [0.0, 2.0, 3.0][run.leaves]
	var got := [leaves, float(run.regime), float(run.flies), run.roll_time >= 0.0]
	var is_rolling := _table.at(row, "t_roll") >= 0.0
	var wanted := [
		_table.at(row, "leaves"), _table.at(row, "regime"), _table.at(row, "flies"), is_rolling
	]
	if got != wanted:
		wrong.append(row)
	var family := _table.family(row)
	worst.note(family, _table.error(row, run.roll_time, "t_roll", "condition_roll"))
	worst.note(family, _table.error(row, run.time, "t"))
	worst.note(family, _table.error(row, run.distance, "x", "condition_x"))
	worst.note(family, _table.error(row, run.speed, "v", "condition_v"))
	worst.note(family, _table.error(row, run.spin, "spin", "condition_spin"))


func _incline(row: int) -> Incline:
	var segment := LineSegment.new(_table.vector(row, "ax", "ay"), _table.vector(row, "bx", "by"))
	var gravity := _table.vector(row, "gx", "gy")
	return Incline.new(segment, gravity, _table.at(row, "friction"), _table.at(row, "belt"))


func test_down_a_slope_of_3_to_4_it_slides_with_360_and_rolls_with_240() -> void:
	var rows: Array[PackedFloat64Array] = [[0.0, 360.0], [0.25, 240.0], [1.0, 240.0]]
	for row in rows:
		var run := _slope(row[0]).run(20, 0, 0, 0, 0.5)
		assert_almost_eq(run.speed, 0.5 * row[1], 1e-12)
		assert_almost_eq(run.distance, 0.125 * row[1], 1e-12)


func test_120_px_take_1_s_rolling_and_0_816_s_sliding() -> void:
	var gravity := Vec2.new(0, 600)
	var slope := LineSegment.new(Vec2.zero(), Vec2.new(96, 72))
	var rolling := Incline.new(slope, gravity, 0.3).run(20, 0, 0, 0, 9)
	assert_eq([rolling.leaves, rolling.roll_time], [InclineRun.End.END, 0.0])
	assert_almost_eq(rolling.time, 1.0, 1e-15)
	var sliding := Incline.new(slope, gravity, 0.0).run(20, 0, 0, 0, 9)
	assert_almost_eq(sliding.time, sqrt(2.0 / 3.0), 1e-15)


func test_a_quarter_is_where_a_slope_of_3_to_4_begins_to_hold() -> void:
	assert_true(_slope(0.25).can_hold())
	assert_false(_slope(0.2499).can_hold())


func test_on_the_level_it_rolls_at_two_thirds_after_a_while() -> void:
	var floor_line := LineSegment.new(Vec2.zero(), Vec2.new(900, 0))
	var run := Incline.new(floor_line, Vec2.new(0, 600), 0.2).run(20, 0, 300, 0, 2)
	assert_eq(run.regime, InclineRun.Regime.ROLLS)
	assert_almost_eq(run.roll_time, 300.0 / 360.0, 1e-15)
	assert_almost_eq(run.speed, 200.0, 1e-12)
	assert_almost_eq(run.spin, 10.0, 1e-14)


func test_a_disc_put_on_a_belt_ends_at_a_third_of_its_speed_and_spins_backwards() -> void:
	var floor_line := LineSegment.new(Vec2.zero(), Vec2.new(900, 0))
	var run := Incline.new(floor_line, Vec2.new(0, 600), 0.2, 90).run(20, 100, 0, 0, 3)
	assert_eq(run.regime, InclineRun.Regime.ROLLS)
	assert_almost_eq(run.speed, 30.0, 1e-12)
	assert_almost_eq(run.spin, -3.0, 1e-13)


# About any point of the line nothing turns the ball: gravity and the line's push are in balance.
func test_on_a_level_line_and_a_belt_the_angular_momentum_about_the_line_stays() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 71
	for number: int in 200:
		var belt := rng.randf_range(-200, 200)
		var incline := Incline.new(
			LineSegment.new(Vec2.zero(), Vec2.new(1000, 0)), Vec2.new(0, 600), 0.3, belt
		)
		var speed := rng.randf_range(-300, 300)
		var spin := rng.randf_range(-30, 30)
		var run := incline.run(20, 500, speed, spin, 1.0)
		assert_almost_eq(run.speed + 10.0 * run.spin, speed + 10.0 * spin, 1e-10)


func test_the_line_turned_round_or_mirrored_gives_the_same_run() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 72
	for number: int in 200:
		var end := Vec2.random_unit(rng).scaled(400)
		var gravity := Vec2.random_unit(rng).scaled(600)
		var friction := rng.randf_range(0, 0.5)
		var speed := rng.randf_range(-300, 300)
		var spin := rng.randf_range(-30, 30)
		var there := LineSegment.new(Vec2.zero(), end)
		var back := LineSegment.new(end, Vec2.zero())
		var one := Incline.new(there, gravity, friction, 50).run(20, 150, speed, spin, 0.7)
		var other := Incline.new(back, gravity, friction, -50).run(20, 250, -speed, spin, 0.7)
		assert_almost_eq(one.distance + other.distance, 400.0, 1e-9)
		assert_almost_eq(one.speed + other.speed, 0.0, 1e-9)
		assert_almost_eq(one.spin, other.spin, 1e-9)


# A run to a time and on from there is a run to both times together.
func test_a_run_can_be_cut_anywhere() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 73
	var incline := _slope(0.1)
	for number: int in 200:
		var speed := rng.randf_range(-300, 300)
		var spin := rng.randf_range(-30, 30)
		var last := rng.randf()
		var whole := incline.run(20, 500, speed, spin, last)
		assert_almost_eq(whole.time, last, 1e-15)
		var part := incline.run(20, 500, speed, spin, last * rng.randf())
		var rest := incline.run(20, part.distance, part.speed, part.spin, last - part.time)
		assert_almost_eq(rest.distance, whole.distance, 1e-9)
		assert_almost_eq(rest.spin, whole.spin, 1e-9)


func test_in_frames_it_comes_near_but_never_rolls() -> void:
	var floor_line := LineSegment.new(Vec2.zero(), Vec2.new(900, 0))
	var incline := Incline.new(floor_line, Vec2.new(0, 600), 0.2)
	var run := incline.run_by_frames(20, 0, 300, 0, 2, 1.0 / 60.0)
	assert_almost_eq(run.speed, 200.0, 5.0)
	assert_ne(run.regime, InclineRun.Regime.ROLLS)
	assert_ne(incline.slip(20, run.speed, run.spin), 0.0)


func test_what_cannot_be_used_is_an_error() -> void:
	var level := LineSegment.new(Vec2.zero(), Vec2.new(900, 0))
	Incline.new(level, Vec2.new(5, 0), 0.2).run(20, 0, 1, 0, 1)
	assert_push_error("Gravity must press on the line, but (5, 0) is along it.")
	Incline.new(level, Vec2.new(0, NAN), 0.2).run(20, 0, 1, 0, 1)
	assert_push_error("Gravity must be within -1e+70..1e+70 px/s² in x and y, not (0, nan).")
	Incline.new(level, Vec2.new(0, 5), -0.2).run(20, 0, 1, 0, 1)
	assert_push_error("The friction µ must be within 0..1e+152, not -0.2.")
	Incline.new(LineSegment.new(Vec2.zero(), Vec2.zero()), Vec2.new(0, 5), 0.2).run(20, 0, 1, 0, 1)
	assert_push_error("A segment must be longer than 0")
	Incline.new(level, Vec2.new(0, 5), 0.2, INF).run(20, 0, 1, 0, 1)
	assert_push_error("The speed of a belt must be within -1e+70..1e+70 px/s, not inf.")
	var good := Incline.new(level, Vec2.new(0, 5), 0.2)
	good.run(0, 0, 1, 0, 1)
	assert_push_error("A ball's radius must be within 1e-70..1e+70 px, not 0.0.")
	good.run(20, 901, 1, 0, 1)
	assert_push_error("The ball must be 0..900.0 px from the start of the line, not 901.0.")
	good.run(20, 0, NAN, 0, 1)
	assert_push_error("The ball's speed must be within -1e+70..1e+70 px/s, not nan.")
	good.run_by_frames(20, 0, 1, 0, 1, 0.0)
	assert_push_error("A frame must take more than 0 s, not 0.0 s.")
	var kept := good.run(20, 5, 1, 0, INF)
	assert_push_error("A run must take 0..1e+70 s, not inf s.")
	assert_eq([kept.distance, kept.speed, kept.time], [5.0, 1.0, 0.0])


static func _slope(friction: float) -> Incline:
	var slope := LineSegment.new(Vec2.zero(), Vec2.new(800, 600))
	return Incline.new(slope, Vec2.new(0, 600), friction)
