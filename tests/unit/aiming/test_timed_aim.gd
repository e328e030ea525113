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
	var bullet := Vec2.unit_radians(angle).scaled(speed)
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
