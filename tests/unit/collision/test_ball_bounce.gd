extends LabTest
## Two balls under Newton's laws, with the worked numbers of the course.


func test_the_centre_of_mass_of_1_and_2_at_6_and_0_moves_at_2() -> void:
	assert_eq(BallBounce.center_speed(_ball(6, 1), _ball(0, 2), Vec2.new(1, 0)), 2.0)


func test_the_courses_numbers_in_one_dimension() -> void:
	for row: Vector3 in [Vector3(1, -2, 4), Vector3(0.5, 0, 3), Vector3(0, 2, 2)]:
		var one := _ball(6, 1)
		var other := _ball(0, 2)
		BallBounce.apply(one, other, Vec2.new(-1, 0), row.x)
		assert_almost_eq(one.velocity.x, float(row.y), 1e-15)
		assert_almost_eq(other.velocity.x, float(row.z), 1e-15)


func test_each_speed_is_mirrored_at_that_of_the_centre_of_mass() -> void:
	var vectors := random_vectors(91, 60)
	var differences := PackedFloat64Array()
	for index: int in range(0, vectors.size(), 3):
		differences.append(_distance_from_mirror(vectors.slice(index, index + 3), 0.7))
	assert_all_at_most(differences, 1e-12)


func test_balls_that_move_apart_are_left_alone() -> void:
	var one := _ball(6, 1)
	var other := _ball(0, 2)
	BallBounce.apply(one, other, Vec2.new(1, 0), 1.0)
	assert_vec2(one.velocity, Vec2.new(6, 0), 0.0)
	assert_vec2(other.velocity, Vec2.new(0, 0), 0.0)


func test_momentum_and_energy_are_kept() -> void:
	var one := Ball.new(Vec2.zero(), 1, Vec2.new(3, -4), 2)
	var other := Ball.new(Vec2.zero(), 1, Vec2.new(-1, 7), 5)
	BallBounce.apply(one, other, Vec2.unit_degrees(200), 1.0)
	var momentum := one.velocity.scaled(2).plus(other.velocity.scaled(5))
	assert_vec2(momentum, Vec2.new(1, 27), 1e-14)
	assert_almost_eq(
		one.velocity.length_squared() + 2.5 * other.velocity.length_squared(), 150.0, 1e-12
	)


static func _ball(speed: float, mass: float) -> Ball:
	return Ball.new(Vec2.zero(), 1.0, Vec2.new(speed, 0), mass)


# How far v' = u - C (v - u) is from the answer, for three random vectors.
static func _distance_from_mirror(three: Array[Vec2], bounciness: float) -> float:
	var normal := three[2].normalized()
	var one := Ball.new(Vec2.zero(), 1.0, three[0], 1.5)
	var other := Ball.new(Vec2.zero(), 1.0, three[1], 4.0)
	if three[0].minus(three[1]).dot(normal) >= 0.0:
		normal = normal.negated()
	var center := BallBounce.center_speed(one, other, normal)
	var wanted := center - bounciness * (one.velocity.dot(normal) - center)
	BallBounce.apply(one, other, normal, bounciness)
	return absf(one.velocity.dot(normal) - wanted)
