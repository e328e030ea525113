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
