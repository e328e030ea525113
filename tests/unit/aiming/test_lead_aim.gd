extends LabTest
## Shots ahead of a moving target, against the reference table.

const _BAR := 4.0

var _table := MotionTable.new("aim_lead")


func test_every_row_is_answered_to_the_last_bits() -> void:
	var worst := WorstErrors.new()
	var wrong: PackedInt32Array = []
	for row: int in _table.size():
		var aim := LeadAim.first(_shooter(row), _target(row), _table.at(row, "speed"), _own(row))
		if aim.hit != (_table.at(row, "hit") == 1.0):
			wrong.append(row)
		elif aim.hit:
			worst.note(_table.family(row), _table.error(row, aim.time, "t"))
			var wanted := _table.vector(row, "dx", "dy")
			worst.note(_table.family(row), _table.aim_error(row, aim.direction, wanted))
	assert_eq(wrong, PackedInt32Array())
	for error in worst.values():
		assert_lt(error, _BAR, str(worst))
	print(worst)


func _shooter(row: int) -> Vec2:
	return _table.vector(row, "sx", "sy")


func _own(row: int) -> Vec2:
	return _table.vector(row, "ux", "uy")


func _target(row: int) -> AimTarget:
	var radius := _table.at(row, "radius")
	return AimTarget.new(
		_table.vector(row, "tx", "ty"), _table.vector(row, "vx", "vy"), Vec2.zero(), radius
	)


func test_the_slide_s_numbers() -> void:
	var target := AimTarget.new(Vec2.new(240, 0), Vec2.new(0, 90))
	for aim: Aim in [
		LeadAim.first(Vec2.zero(), target, 150),
		LeadAim.first_by_the_slide(Vec2.zero(), target, 150)
	]:
		assert_almost_eq(aim.time, 2.0, 1e-15)
		assert_true(aim.direction.equals_approx(Vec2.new(0.8, 0.6), 1e-15))
		assert_true(aim.target.equals_approx(Vec2.new(240, 180), 1e-12))


func test_a_shooter_that_moves_along_aims_straight_at_the_target() -> void:
	var target := AimTarget.new(Vec2.new(240, 0), Vec2.new(0, 90))
	var aim := LeadAim.first(Vec2.zero(), target, 150, Vec2.new(0, 90))
	assert_true(aim.direction.equals_approx(Vec2.new(1, 0), 1e-15))


func test_a_target_that_is_faster_and_flees_is_outrun() -> void:
	var target := AimTarget.new(Vec2.new(240, 0), Vec2.new(200, 0))
	var aim := LeadAim.first(Vec2.zero(), target, 150)
	assert_false(aim.hit)
	assert_eq(aim.outcome, Aim.Outcome.OUTRUN)


func test_by_the_slide_nearly_equal_speeds_lose_their_digits() -> void:
	var worst := 0.0
	for row: int in _table.size():
		if _table.family(row) == "nearly-equal-speed" and _table.at(row, "hit") == 1.0:
			var speed := _table.at(row, "speed")
			var aim := LeadAim.first_by_the_slide(_shooter(row), _target(row), speed, _own(row))
			worst = maxf(worst, _table.error(row, aim.time, "t"))
	assert_gt(worst, 1e6)


func test_a_speed_that_is_none_is_an_error() -> void:
	var target := AimTarget.new(Vec2.new(240, 0))
	for speed: float in [0.0, -5.0, NAN, INF]:
		assert_false(LeadAim.first(Vec2.zero(), target, speed).hit)
		assert_push_error("must be above 0 px/s")


func test_a_target_shares_no_vector() -> void:
	var place := Vec2.new(240, 0)
	var target := AimTarget.new(place)
	place.set_xy(0, 0)
	assert_eq(target.position.x, 240.0)
