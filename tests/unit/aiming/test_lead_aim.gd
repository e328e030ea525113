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
