extends LabTest
## The moment to fire, with a fixed and with a turning barrel, against the reference table.

const _BAR := 4.0

var _table := MotionTable.new("aim_timed")


func test_every_row_is_answered_to_the_last_bits() -> void:
	var worst := WorstErrors.new()
	var wrong: PackedInt32Array = []
	for row: int in _table.size():
		var shot := _shot(row)
		if shot.hit != (_table.at(row, "hit") == 1.0):
			wrong.append(row)
		elif shot.hit:
			worst.note(_table.family(row), _table.error(row, shot.fire, "fire"))
			var error := _table.error(row, shot.flight, "flight", "condition_flight")
			worst.note(_table.family(row), error)
	assert_eq(wrong, PackedInt32Array())
	print(worst)
	for error in worst.values():
		assert_lt(error, _BAR, str(worst))


func _shot(row: int) -> TimedShot:
	var muzzle := _at(row, "s")
	var speed := _table.at(row, "speed")
	var angle := _table.at(row, "angle")
	var bullet := _bullet(row)
	var rho := _table.at(row, "rho")
	if _table.at(row, "turn") != 0.0:
		var target := AimTarget.new(_at(row, "t"), _at(row, "v"))
		return TurningBarrel.new(muzzle, angle, _table.at(row, "turn"), speed, target).first()
	if rho == 0.0:
		return TimedAim.at_line(muzzle, bullet, _at(row, "g"), _at(row, "t"), _at(row, "v"))
	var phase := _table.at(row, "alpha")
	var turn := _table.at(row, "omega")
	return TimedAim.at_circle(muzzle, bullet, _at(row, "g"), _at(row, "t"), rho, phase, turn)


func _at(row: int, letter: String) -> Vec2:
	return _table.vector(row, letter + "x", letter + "y")


func test_the_slide_s_numbers() -> void:
	var bullet := Vec2.new(0, -200)
	var velocity := Vec2.new(100, 0)
	var muzzle := Vec2.new(300, 400)
	var shot := TimedAim.at_line(muzzle, bullet, Vec2.zero(), Vec2.new(0, 200), velocity)
	assert_almost_eq(shot.fire, 2.0, 1e-15)
	assert_almost_eq(shot.flight, 1.0, 1e-15)
	assert_almost_eq(TimedAim.window(bullet, velocity, 10), 0.1118, 1e-4)
	shot = TimedAim.at_line_by_the_slide(muzzle, bullet, Vec2.new(0, 200), velocity)
	assert_almost_eq(shot.fire, 2.0, 1e-15)
	assert_almost_eq(shot.flight, 1.0, 1e-15)


func test_a_circle_by_the_slide() -> void:
	# The bullet comes to (0, -100) after half a second; the target is there after a whole one.
	for solver: Callable in [
		TimedAim.at_circle_by_the_slide,
		func(
			muzzle: Vec2, bullet: Vec2, centre: Vec2, radius: float, phase: float, turn: float
		) -> TimedShot:
			return TimedAim.at_circle(muzzle, bullet, Vec2.zero(), centre, radius, phase, turn)
	]:
		var muzzle := Vec2.new(0, -200)
		var bullet := Vec2.new(0, 200)
		var shot: TimedShot = solver.call(muzzle, bullet, Vec2.zero(), 100.0, 0.0, -PI / 2)
		assert_almost_eq(shot.fire, 0.5, 1e-14)
		assert_almost_eq(shot.flight, 0.5, 1e-14)


func test_by_the_slide_the_digits_cancel_where_the_ways_hardly_cross() -> void:
	var by_the_slide := 0.0
	var careful := 0.0
	for row: int in _table.size():
		if _table.family(row) in ["line", "slow-crossing"] and _table.at(row, "hit") == 1.0:
			var bullet := _bullet(row)
			var muzzle := _at(row, "s")
			var shot := TimedAim.at_line_by_the_slide(muzzle, bullet, _at(row, "t"), _at(row, "v"))
			by_the_slide = maxf(by_the_slide, _table.error(row, shot.fire, "fire"))
			careful = maxf(careful, _table.error(row, _shot(row).fire, "fire"))
	assert_gt(by_the_slide, 20.0)
	assert_lt(careful, 1.0)


func test_by_the_slide_the_digits_cancel_where_the_bullet_grazes_the_circle() -> void:
	var by_the_slide := 0.0
	var careful := 0.0
	for row: int in _table.size():
		if _table.family(row) == "circle" and _table.at(row, "hit") == 1.0:
			var phase := _table.at(row, "alpha")
			var shot := TimedAim.at_circle_by_the_slide(
				_at(row, "s"),
				_bullet(row),
				_at(row, "t"),
				_table.at(row, "rho"),
				phase,
				_table.at(row, "omega")
			)
			by_the_slide = maxf(by_the_slide, _flight_error(row, shot))
			careful = maxf(careful, _flight_error(row, _shot(row)))
	assert_gt(by_the_slide, 5.0)
	assert_lt(careful, 1.0)


func test_by_the_slide_parallel_ways_are_told() -> void:
	var velocity := Vec2.new(100, 0)
	var shot := TimedAim.at_line_by_the_slide(Vec2.zero(), velocity, Vec2.new(0, 20), velocity)
	assert_eq(shot.outcome, TimedShot.Outcome.PARALLEL)


func _bullet(row: int) -> Vec2:
	return Vec2.unit_radians(_table.at(row, "angle")).scaled(_table.at(row, "speed"))


func _flight_error(row: int, shot: TimedShot) -> float:
	return _table.error(row, shot.flight, "flight", "condition_flight")


func test_parallel_ways_are_told() -> void:
	var velocity := Vec2.new(100, 0)
	var target := Vec2.new(0, 20)
	var shot := TimedAim.at_line(Vec2.zero(), Vec2.new(50, 0), Vec2.zero(), target, velocity)
	assert_eq(shot.outcome, TimedShot.Outcome.PARALLEL)


func test_a_bullet_that_leaves_the_circle_from_its_rim_never_hits() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 7
	for each in 500:
		var centre := Vec2.random_unit(rng).scaled(100.0)
		var muzzle := centre.plus(Vec2.random_unit(rng).scaled(rng.randf_range(20.0, 200.0)))
		var outward := muzzle.minus(centre)
		var bullet := outward.normalized().scaled(200.0)
		bullet.rotate_radians(rng.randf_range(-1.4, 1.4))
		var phase := rng.randf_range(-PI, PI)
		var radius := outward.length()
		var shot := TimedAim.at_circle(muzzle, bullet, Vec2.zero(), centre, radius, phase, 1.5)
		assert_false(shot.hit, "%s from %s" % [bullet, outward])


func test_a_target_that_has_passed_is_told() -> void:
	var velocity := Vec2.new(100, 0)
	var target := Vec2.new(500, 200)
	var bullet := Vec2.new(0, -200)
	var shot := TimedAim.at_line(Vec2.new(300, 400), bullet, Vec2.zero(), target, velocity)
	assert_eq(shot.outcome, TimedShot.Outcome.NOT_IN_TIME)


func test_a_barrel_that_points_right_already_fires_at_once() -> void:
	for angle: float in [0.0, PI / 2]:
		var target := AimTarget.new(Vec2.unit_radians(angle).scaled(100))
		for turn: float in [1.0, -1.0]:
			var shot := TurningBarrel.new(Vec2.zero(), angle, turn, 50, target).first()
			assert_almost_eq(shot.fire, 0.0, 1e-15)
			assert_almost_eq(shot.flight, 2.0, 1e-15)


func test_a_barrel_fires_although_the_lead_overtakes_it_only_for_a_moment() -> void:
	# The direction to aim at passes the barrel after 1.36 s and falls back behind it after 1.5 s.
	var bullet := Vec2.new(580, 116)
	var target := AimTarget.new(Vec2.new(-27, -212), Vec2.new(296, 332.7))
	var muzzle := Vec2.new(250, 200)
	var barrel := TurningBarrel.new(
		muzzle, bullet.angle_radians(), TAU / 16.9, bullet.length(), target
	)
	assert_between(barrel.first().fire, 1.35, 1.37)


func test_a_target_that_no_barrel_can_follow_is_an_error() -> void:
	var target := AimTarget.new(Vec2.new(100, 0), Vec2.new(0, 60))
	assert_false(TurningBarrel.new(Vec2.zero(), 0, 1, 60, target).first().hit)
	assert_push_error("must be faster than the target")
	assert_false(TurningBarrel.new(Vec2.zero(), 0, 1, 0, target).first().hit)
	assert_push_error("must be above 0 px/s")
	var bullet := Vec2.new(50, 0)
	for turn: float in [0.0, NAN]:
		var centre := Vec2.new(90, 0)
		var shot := TimedAim.at_circle(Vec2.zero(), bullet, Vec2.zero(), centre, 20, 0, turn)
		assert_false(shot.hit)
		assert_push_error("must turn")


func test_the_window_of_parallel_ways_has_no_end() -> void:
	assert_eq(TimedAim.window(Vec2.new(50, 0), Vec2.new(20, 0), 10), INF)
