extends LabTest
## Shots over walls, against the reference table.

const _BAR := 4.0

var _table := MotionTable.new("aim_bank")


func test_every_row_is_answered_to_the_last_bits() -> void:
	var worst := WorstErrors.new()
	var wrong: PackedInt32Array = []
	for row: int in _table.size():
		var way := _first(row)
		if way.hit != (_table.at(row, "hit") == 1.0) or way.hit and not _is_order(row, way):
			wrong.append(row)
		elif way.hit:
			var wanted := _table.vector(row, "dx", "dy")
			worst.note(_table.family(row), _table.error(row, way.distance, "distance"))
			worst.note(_table.family(row), _table.aim_error(row, way.direction, wanted))
	assert_eq(wrong, PackedInt32Array())
	print(worst)
	for error in worst.values():
		assert_lt(error, _BAR, str(worst))


func _first(row: int) -> BankWay:
	var start := _table.vector(row, "sx", "sy")
	var target := _table.vector(row, "tx", "ty")
	var bounciness := _table.at(row, "restitution")
	var bounces := int(_table.at(row, "bounces"))
	return BankAim.first(start, target, _table.at(row, "r"), bounciness, _walls(row), bounces)


func _walls(row: int) -> Array[LineSegment]:
	var walls: Array[LineSegment] = []
	for wall: int in int(_table.at(row, "walls")):
		var from := _table.vector(row, "ax%d" % wall, "ay%d" % wall)
		walls.append(LineSegment.new(from, _table.vector(row, "bx%d" % wall, "by%d" % wall)))
	return walls


func _is_order(row: int, way: BankWay) -> bool:
	for place: int in way.walls.size():
		if way.walls[place] != int(_table.at(row, "wall%d" % (place + 1))):
			return false
	return true
