extends LabTest
## Shots under gravity, against the reference table.

const _BAR := 4.0

var _table := MotionTable.new("aim_ballistic")


func test_every_row_is_answered_to_the_last_bits() -> void:
	var worst := WorstErrors.new()
	var wrong: PackedInt32Array = []
	for row: int in _table.size():
		var shots := _shots(row)
		if shots.size() != int(_table.at(row, "count")):
			wrong.append(row)
			continue
		for place: int in mini(shots.size(), 2):
			_note(worst, row, shots[place], str(place + 1))
	assert_eq(wrong, PackedInt32Array())
	print(worst)
	for error in worst.values():
		assert_lt(error, _BAR, str(worst))


func test_the_least_speed_of_every_row() -> void:
	var worst := WorstErrors.new()
	for row: int in _table.size():
		if _table.at(row, "least_speed") >= 0.0:
			var least := BallisticAim.least_speed(_at(row, "s"), _at(row, "t"), _at(row, "g"))
			var error := _table.error(row, least, "least_speed", "condition_speed")
			worst.note(_table.family(row), error)
	print(worst)
	for error in worst.values():
		assert_lt(error, _BAR, str(worst))


func _note(worst: WorstErrors, row: int, shot: Aim, number: String) -> void:
	var family := _table.family(row)
	worst.note(family, _table.error(row, shot.time, "t" + number, "condition" + number))
	var wanted := _table.vector(row, "d%sx" % number, "d%sy" % number)
	worst.note(family, _table.aim_error(row, shot.direction, wanted, "condition_aim" + number))


# A target that rests is asked for by the closed form.
func _shots(row: int) -> Array[Aim]:
	var speed := _table.at(row, "speed")
	var longest := _table.at(row, "t_max")
	if _table.at(row, "least_speed") >= 0.0:
		var shots := BallisticAim.at_fixed(_at(row, "s"), _at(row, "t"), _at(row, "g"), speed)
		return shots.filter(func(shot: Aim) -> bool: return shot.time <= longest)
	var radius := _table.at(row, "radius")
	var target := AimTarget.new(_at(row, "t"), _at(row, "v"), _at(row, "a"), radius)
	return BallisticAim.at_moving(_at(row, "s"), target, _at(row, "g"), speed, longest)


func _at(row: int, letter: String) -> Vec2:
	return _table.vector(row, letter + "x", letter + "y")


func test_the_slide_s_numbers() -> void:
	var target := Vec2.new(200, 0)
	var careful := BallisticAim.at_fixed(Vec2.zero(), target, Vec2.new(0, 300), 250)
	var by_the_slide := BallisticAim.at_fixed_by_the_slide(Vec2.zero(), target, 300, 250)
	for shots: Array[Aim] in [careful, by_the_slide]:
		assert_eq(shots.size(), 2)
		assert_almost_eq(shots[0].time, 1.0, 1e-15)
		assert_true(shots[0].direction.equals_approx(Vec2.new(0.8, -0.6), 1e-15))
		assert_almost_eq(shots[1].time, 4.0 / 3.0, 1e-15)
		assert_true(shots[1].direction.equals_approx(Vec2.new(0.6, -0.8), 1e-15))


func test_the_edge_of_what_can_be_reached() -> void:
	var least := BallisticAim.least_speed(Vec2.zero(), Vec2.new(200, 0), Vec2.new(0, 300))
	assert_almost_eq(least, sqrt(60000.0), 1e-12)
	assert_eq(BallisticAim.at_fixed(Vec2.zero(), Vec2.new(200, 0), Vec2.new(0, 300), 240), [])


func test_straight_up_is_no_special_case() -> void:
	var shots := BallisticAim.at_fixed(Vec2.zero(), Vec2.new(0, -100), Vec2.new(0, 300), 250)
	assert_eq(shots.size(), 2)
	for shot: Aim in shots:
		assert_true(shot.direction.equals_approx(Vec2.new(0, -1), 1e-15))


func test_a_target_that_falls_is_aimed_at_straight() -> void:
	var gravity := Vec2.new(0, 300)
	var target := AimTarget.new(Vec2.new(200, 0), Vec2.zero(), gravity)
	var shots := BallisticAim.at_moving(Vec2.zero(), target, gravity, 250, 10)
	assert_eq(shots.size(), 1)
	assert_true(shots[0].direction.equals_approx(Vec2.new(1, 0), 1e-15))


func test_a_speed_that_is_none_is_an_error() -> void:
	assert_eq(BallisticAim.at_fixed(Vec2.zero(), Vec2.new(1, 0), Vec2.zero(), 0.0), [])
	assert_push_error("must be above 0 px/s")
