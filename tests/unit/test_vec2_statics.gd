extends LabTest
## Vectors made without another vector.


func test_zero_is_zero_and_new_at_each_call() -> void:
	var first := Vec2.zero()
	first.set_xy(1, 2)
	assert_vec2(Vec2.zero(), Vec2.new(0, 0), 0.0)


func test_unit_degrees_is_exact_at_quarter_turns() -> void:
	assert_vec2(Vec2.unit_degrees(0), Vec2.new(1, 0), 0.0)
	assert_vec2(Vec2.unit_degrees(90), Vec2.new(0, 1), 0.0)
	assert_vec2(Vec2.unit_degrees(180), Vec2.new(-1, 0), 0.0)
	assert_vec2(Vec2.unit_degrees(270), Vec2.new(0, -1), 0.0)
	assert_vec2(Vec2.unit_degrees(-90), Vec2.new(0, -1), 0.0)


func test_unit_degrees_points_into_all_four_quadrants() -> void:
	var third := sqrt(3.0) / 2.0
	assert_vec2(Vec2.unit_degrees(60), Vec2.new(0.5, third), 2.0 * EPSILON)
	assert_vec2(Vec2.unit_degrees(150), Vec2.new(-third, 0.5), 2.0 * EPSILON)
	assert_vec2(Vec2.unit_degrees(210), Vec2.new(-third, -0.5), 2.0 * EPSILON)
	assert_vec2(Vec2.unit_degrees(-60), Vec2.new(0.5, -third), 2.0 * EPSILON)


func test_unit_radians_points_at_the_angle() -> void:
	assert_vec2(Vec2.unit_radians(0), Vec2.new(1, 0), 0.0)
	assert_vec2(Vec2.unit_radians(PI / 6.0), Vec2.new(sqrt(3.0) / 2.0, 0.5), EPSILON)
	assert_vec2(Vec2.unit_radians(-PI / 2.0), Vec2.new(0, -1), EPSILON)


func test_unit_vectors_have_length_1() -> void:
	var errors := PackedFloat64Array()
	for step: int in 1000:
		var unit := Vec2.unit_degrees(step * 0.7391 - 400.0)
		errors.append(absf(ExactProjection.dot(unit, unit).square_root().error_of(1.0)))
	assert_all_at_most(errors, 2.0 * EPSILON)


func test_large_angles_in_degrees_are_as_good_as_small_ones() -> void:
	assert_vec2(Vec2.unit_degrees(1e9), Vec2.unit_degrees(280), 0.0)
	assert_vec2(Vec2.unit_degrees(-1e9), Vec2.unit_degrees(-280), 0.0)


func test_random_units_have_length_1() -> void:
	var errors := PackedFloat64Array()
	for unit: Vec2 in _random_units(71, 10000):
		errors.append(absf(ExactProjection.dot(unit, unit).square_root().error_of(1.0)))
	assert_all_at_most(errors, 2.0 * EPSILON)


func test_random_units_fill_all_four_quadrants_alike() -> void:
	var counts: Array[int] = [0, 0, 0, 0]
	for unit: Vec2 in _random_units(72, 10000):
		counts[(1 if unit.x < 0.0 else 0) + (2 if unit.y < 0.0 else 0)] += 1
	# 2500 are expected; five standard deviations of sqrt(10000 / 4 * 3 / 4) are 217.
	for count: int in counts:
		assert_between(count, 2283, 2717)


func test_random_units_favour_no_angle() -> void:
	var bins := PackedInt32Array()
	bins.resize(36)
	for unit: Vec2 in _random_units(73, 10000):
		bins[mini(int((atan2(unit.y, unit.x) + PI) / TAU * 36.0), 35)] += 1
	var chi_square := 0.0
	for count: int in bins:
		chi_square += (count - 10000.0 / 36.0) ** 2 / (10000.0 / 36.0)
	# With 35 degrees of freedom, 66.6 is exceeded once in a thousand; too even is wrong as well.
	assert_between(chi_square, 14.0, 66.6)


func test_random_units_are_not_at_whole_degrees_only() -> void:
	var angles: Dictionary[float, bool] = {}
	for unit: Vec2 in _random_units(74, 10000):
		angles[atan2(unit.y, unit.x)] = true
	assert_eq(angles.size(), 10000)


func test_a_random_unit_takes_its_share_of_the_whole_circle_from_one_random_number() -> void:
	var rng := RandomNumberGenerator.new()
	var same_rng := RandomNumberGenerator.new()
	rng.seed = 76
	same_rng.seed = 76
	for _index: int in 20:
		var wanted := Vec2.unit_degrees(360.0 * (same_rng.randi() / 4294967296.0))
		assert_vec2(Vec2.random_unit(rng), wanted, 1e-15)


func test_the_same_seed_gives_the_same_random_units() -> void:
	assert_vec2(_random_units(75, 20)[19], _random_units(75, 20)[19], 0.0)


func _random_units(seed_number: int, count: int) -> Array[Vec2]:
	var rng := RandomNumberGenerator.new()
	rng.seed = seed_number
	var units: Array[Vec2] = []
	for _index: int in count:
		units.append(Vec2.random_unit(rng))
	return units
