extends LabTest
## The error of a reflection against about 100 bits.


func test_the_numbers_of_the_lecture_have_no_error() -> void:
	var along := Vec2.new(7, 0)
	var velocity := Vec2.new(3, 4)
	assert_eq(ExactReflection.error_of(Vec2.new(3, -4), velocity, along, 2.0), 0.0)
	assert_eq(ExactReflection.error_of(Vec2.new(3, 0), velocity, along, 1.0), 0.0)
	assert_eq(ExactReflection.error_of(Vec2.new(3, -2), velocity, along, 1.5), 0.0)


func test_the_error_is_the_distance_from_the_exact_answer() -> void:
	var got := Vec2.new(6, 0)
	assert_eq(ExactReflection.error_of(got, Vec2.new(3, 4), Vec2.new(7, 0), 2.0), 5.0)


func test_an_angled_line_is_exact_as_well() -> void:
	# A line along (4, 3) reflects (0, 5) to (4.8, -1.4). Neither number is a double.
	var error := ExactReflection.error_of(Vec2.new(4.8, -1.4), Vec2.new(0, 5), Vec2.new(4, 3), 2.0)
	assert_between(error, 1e-18, 3e-16)


func test_the_length_of_the_line_does_not_matter() -> void:
	var got := Vec2.new(1, 2)
	var errors := PackedFloat64Array()
	for size: float in [1e-100, 1e-3, 1e100]:
		var along := Vec2.new(4, 3).scaled(size)
		var error := ExactReflection.error_of(got, Vec2.new(0, 5), along, 2.0)
		errors.append(absf(error - Vec2.new(1 - 4.8, 2 + 1.4).length()))
	assert_all_at_most(errors, 1e-14)


func test_a_line_without_direction_leaves_the_velocity() -> void:
	assert_eq(ExactReflection.error_of(Vec2.new(3, 4), Vec2.new(3, 4), Vec2.zero(), 2.0), 0.0)
