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
	return _way(row, BankAim.first)


func _way(row: int, solver: Callable) -> BankWay:
	var start := _table.vector(row, "sx", "sy")
	var target := _table.vector(row, "tx", "ty")
	var bounciness := _table.at(row, "restitution")
	var bounces := int(_table.at(row, "bounces"))
	var radius := _table.at(row, "r")
	return solver.call(start, target, radius, bounciness, _walls(row), bounces)


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


func test_the_slide_s_numbers() -> void:
	var floor_line: Array[LineSegment] = [LineSegment.new(Vec2.new(0, 300), Vec2.new(500, 300))]
	var start := Vec2.new(100, 100)
	var way := BankAim.first(start, Vec2.new(300, 160), 20, 1, floor_line, 1)
	assert_true(way.hit)
	assert_true(way.images[0].equals_approx(Vec2.new(300, 400), 1e-12))
	assert_true(way.bounces[0].equals_approx(Vec2.new(220, 280), 1e-12))
	way = BankAim.first(start, Vec2.new(300, 160), 20, 0.5, floor_line, 1)
	assert_true(way.images[0].equals_approx(Vec2.new(300, 520), 1e-12))
	for bounciness: float in [1.0, 0.5]:
		way = BankAim.first_by_the_slide(start, Vec2.new(300, 160), 20, bounciness, floor_line, 1)
		assert_true(way.hit)
		var image := Vec2.new(300, 400 if bounciness == 1.0 else 520)
		assert_vec2(way.images[0], image, 1e-12)
		assert_vec2(way.direction, image.minus(start).normalized(), 1e-15)


func test_by_the_slide_the_nearest_image_is_right_only_where_nothing_is_in_the_way() -> void:
	var worst := WorstErrors.new()
	var wrong := 0
	for row: int in _table.size():
		var way := _way(row, BankAim.first_by_the_slide)
		if way.hit != (_table.at(row, "hit") == 1.0) or way.hit and not _is_order(row, way):
			wrong += 1
		elif way.hit:
			var wanted := _table.vector(row, "dx", "dy")
			worst.note("right order", _table.aim_error(row, way.direction, wanted))
	print("by the slide: %d of %d rows wrong, %s" % [wrong, _table.size(), worst])
	assert_between(wrong, 100, _table.size() - 30)
	assert_lt(worst.values()[0], _BAR)


func test_by_the_slide_the_last_wall_comes_first() -> void:
	# A slanted pair: a right angle would hide a wrong order.
	var walls: Array[LineSegment] = [
		LineSegment.new(Vec2.new(-400, 300), Vec2.new(400, 300)),
		LineSegment.new(Vec2.new(400, 300), Vec2.new(200, -300))
	]
	var start := Vec2.new(100, 200)
	var target := Vec2.new(150, -50)
	var way := BankAim.first_by_the_slide(start, target, 10, 1, walls, 2)
	var careful := BankAim.first(start, target, 10, 1, walls, 2)
	assert_eq(careful.walls, PackedInt32Array([0, 1]))
	assert_eq(way.walls, careful.walls)
	assert_vec2(way.direction, careful.direction, 1e-15)


func test_each_way_says_why_it_is_none() -> void:
	var walls: Array[LineSegment] = [
		LineSegment.new(Vec2.new(0, 300), Vec2.new(210, 300)),
		LineSegment.new(Vec2.new(150, 200), Vec2.new(150, 240)),
		LineSegment.new(Vec2.new(0, 50), Vec2.new(500, 50)),
	]
	var outcomes: Array[BankWay.Outcome] = []
	for way in BankAim.ways(Vec2.new(100, 100), Vec2.new(300, 160), 20, 1, walls, 1):
		outcomes.append(way.outcome)
	assert_has(outcomes, BankWay.Outcome.BESIDE)
	assert_has(outcomes, BankWay.Outcome.HIT)
	assert_false(BankAim.first(Vec2.zero(), Vec2.new(1, 1), 1, 1, [], 1).hit)


func test_a_c_that_is_none_is_an_error() -> void:
	assert_false(BankAim.first(Vec2.zero(), Vec2.new(1, 1), 1, 0.0, [], 1).hit)
	assert_push_error("C must be above 0")
	assert_false(BankAim.first_by_the_slide(Vec2.zero(), Vec2.new(1, 1), 1, 1.5, [], 1).hit)
	assert_push_error("C must be above 0")
	assert_false(BankAim.first(Vec2.zero(), Vec2.new(1, 1), 1, 1.0, [], -1).hit)
	assert_push_error("must be 0 or more")
