extends LabTest
## Rotating, rotating around a point, and setting the angle.


func test_rotating_2_5_by_90_degrees_is_exact() -> void:
	var vector := Vec2.new(2, 5)
	vector.rotate_degrees(90)
	assert_vec2(vector, Vec2.new(-5, 2), 0.0)


func test_quarter_turns_are_exact_in_both_directions() -> void:
	var wanted: Dictionary[float, Vec2] = {
		-270.0: Vec2.new(-5, 2),
		-90.0: Vec2.new(5, -2),
		180.0: Vec2.new(-2, -5),
		270.0: Vec2.new(5, -2),
		360.0: Vec2.new(2, 5),
		-720.0: Vec2.new(2, 5),
		3.6e14 + 90.0: Vec2.new(-5, 2),
	}
	for angle: float in wanted:
		var vector := Vec2.new(2, 5)
		vector.rotate_degrees(angle)
		assert_vec2(vector, wanted[angle], 0.0, "%s degrees" % angle)


func test_rotating_by_30_degrees() -> void:
	var vector := Vec2.new(2, 0)
	vector.rotate_degrees(30)
	assert_vec2(vector, Vec2.new(sqrt(3.0), 1), 1e-15)


func test_rotating_by_radians() -> void:
	var vector := Vec2.new(2, 5)
	vector.rotate_radians(PI / 2.0)
	assert_vec2(vector, Vec2.new(-5, 2), 1e-15)


func test_degrees_and_radians_agree() -> void:
	for vector: Vec2 in random_vectors(51, 50):
		var other := vector.copy()
		vector.rotate_degrees(77.7)
		other.rotate_radians(77.7 * PI / 180.0)
		assert_vec2(vector, other, 1e-13)


func test_rotating_keeps_the_length() -> void:
	var changes := PackedFloat64Array()
	for vector: Vec2 in random_vectors(52, 200):
		var before := vector.length()
		vector.rotate_radians(vector.x)
		changes.append(absf(vector.length() / before - 1.0))
	assert_all_at_most(changes, 4.0 * EPSILON)


func test_rotating_back_gives_the_vector_back() -> void:
	for vector: Vec2 in random_vectors(53, 50):
		var before := vector.copy()
		vector.rotate_degrees(123.4)
		vector.rotate_degrees(-123.4)
		assert_vec2(vector, before, 1e-13)


func test_a_billion_degrees_are_280() -> void:
	var vector := Vec2.new(10, 0)
	vector.rotate_degrees(1e9)
	# 1e9 = 2777777 * 360 + 280
	assert_vec2(vector, Vec2.new(10.0 * cos(80.0 * PI / 180.0), -10.0 * cos(PI / 18.0)), 1e-14)


func test_a_tiny_rotation_is_not_lost() -> void:
	var vector := Vec2.new(1, 0)
	vector.rotate_degrees(-1e-20)
	assert_almost_eq(vector.y / (-1e-20 * PI / 180.0), 1.0, 1e-15)


func test_rotating_around_a_point() -> void:
	var position := Vec2.new(2, 5)
	position.rotate_around_degrees(Vec2.new(2, 1), 90)
	assert_vec2(position, Vec2.new(-2, 1), 0.0)


func test_rotating_around_a_point_by_radians() -> void:
	var position := Vec2.new(2, 5)
	position.rotate_around_radians(Vec2.new(2, 1), PI / 2.0)
	assert_vec2(position, Vec2.new(-2, 1), 1e-15)


func test_rotating_around_a_point_keeps_the_distance_to_it() -> void:
	var centre := Vec2.new(40, -30)
	for position: Vec2 in random_vectors(54, 50):
		var before := position.distance_to(centre)
		position.rotate_around_radians(centre, position.y)
		assert_almost_eq(position.distance_to(centre), before, 1e-13)


func test_rotating_around_zero_is_rotating() -> void:
	for position: Vec2 in random_vectors(55, 20):
		var other := position.copy()
		position.rotate_around_degrees(Vec2.zero(), 200)
		other.rotate_degrees(200)
		assert_vec2(position, other, 0.0)


func test_set_angle_degrees_keeps_the_length() -> void:
	var vector := Vec2.new(3, 4)
	vector.set_angle_degrees(-90)
	assert_vec2(vector, Vec2.new(0, -5), 0.0)


func test_set_angle_radians_keeps_the_length() -> void:
	var vector := Vec2.new(3, 4)
	vector.set_angle_radians(PI / 6.0)
	assert_vec2(vector, Vec2.new(2.5 * sqrt(3.0), 2.5), 1e-15)


func test_the_angle_set_is_the_angle_read() -> void:
	for vector: Vec2 in random_vectors(56, 50):
		var angle := vector.x
		vector.set_angle_degrees(angle)
		assert_almost_eq(vector.angle_degrees(), angle, 1e-13)


func test_a_zero_vector_stays_zero_when_its_angle_is_set() -> void:
	var vector := Vec2.zero()
	vector.set_angle_degrees(30)
	assert_vec2(vector, Vec2.zero(), 0.0)
	vector.set_angle_radians(1)
	assert_vec2(vector, Vec2.zero(), 0.0)
