extends LabTest
## The exact direction of a bank shot.


func test_the_direction_to_a_whole_image_is_known() -> void:
	var walls: Array[LineSegment] = [LineSegment.new(Vec2.new(0, 300), Vec2.new(400, 300))]
	# The wall's normal points down, the ball is above: S (100, 100), T′ (300, 400).
	var direction := Vec2.new(200, 300).normalized()
	assert_lt(_error(direction, walls, [-1.0], 1.0), 2e-16)
	assert_lt(_error(Vec2.new(200, 420).normalized(), walls, [-1.0], 0.5), 2e-16)
	direction.rotate_radians(1e-6)
	assert_almost_eq(_error(direction, walls, [-1.0], 1.0), 1e-6, 1e-12)


func test_it_mirrors_in_the_last_wall_first() -> void:
	# Off y = 300, then off y = x: the image of (300, 160) in the last one is (160, 300).
	var walls: Array[LineSegment] = [
		LineSegment.new(Vec2.new(0, 300), Vec2.new(400, 300)),
		LineSegment.new(Vec2.zero(), Vec2.new(400, 400)),
	]
	var direction := Vec2.new(60, 200).normalized()
	var error := ExactBank.error_of_direction(
		direction, Vec2.new(100, 100), Vec2.new(300, 160), 0.0, 1.0, walls, [-1.0, 1.0]
	)
	assert_lt(error, 2e-16)


static func _error(
	direction: Vec2, walls: Array[LineSegment], sides: PackedFloat64Array, bounciness: float
) -> float:
	return ExactBank.error_of_direction(
		direction, Vec2.new(100, 100), Vec2.new(300, 160), 20.0, bounciness, walls, sides
	)
