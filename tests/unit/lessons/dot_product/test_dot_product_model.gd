extends LabTest
## Two vectors and the shadow of one on the other, with the formulas of school geometry beside.

const _COUNT := 300


func test_the_numbers_of_the_lecture() -> void:
	var model := _lecture()
	assert_eq(model.dot(), 50.0)
	assert_eq(model.scalar_projection(), 5.0)
	assert_vec2(model.unit(), Vec2.new(0.8, -0.6), 0.0)
	assert_vec2(model.vector_projection(), Vec2.new(4, -3), 0.0)
	assert_vec2(model.rejection(), Vec2.new(3, 4), 0.0)


func test_only_the_difference_of_head_and_tail_counts() -> void:
	var model := _lecture()
	for point: Vec2 in [model.a_tail, model.a_head]:
		point.add(Vec2.new(-12, 30))
	assert_vec2(model.a(), Vec2.new(7, 1), 0.0)
	assert_eq(model.scalar_projection(), 5.0)


func test_the_projection_is_parallel_to_the_vector_projected_on() -> void:
	for model: DotProductModel in _random_models():
		var cross := model.vector_projection().cross(model.onto())
		assert_almost_eq(cross, 0.0, 1e-9)


func test_the_rest_is_perpendicular_and_adds_up() -> void:
	for model: DotProductModel in _random_models():
		assert_almost_eq(model.rejection().dot(model.onto()), 0.0, 1e-9)
		assert_vec2(model.rejection().plus(model.vector_projection()), model.shadowed(), 1e-12)


func test_the_scalar_projection_is_length_times_cosine() -> void:
	for model: DotProductModel in _random_models():
		var angle := atan2(model.a().y, model.a().x) - atan2(model.b().y, model.b().x)
		assert_almost_eq(model.scalar_projection(), model.a().length() * cos(angle), 1e-10)


func test_the_foot_is_the_nearest_point_of_the_line() -> void:
	for model: DotProductModel in _random_models():
		var foot := model.foot(model.a_head)
		for step: float in [-1e-3, 1e-3]:
			var beside := foot.plus(model.onto().scaled(step))
			assert_gt(model.a_head.distance_to(beside), model.a_head.distance_to(foot))


func test_swapped_it_projects_b_on_a() -> void:
	var model := _lecture()
	model.is_swapped = true
	assert_vec2(model.shadowed(), Vec2.new(8, -6), 0.0)
	assert_vec2(model.onto(), Vec2.new(7, 1), 0.0)
	assert_vec2(model.vector_projection(), Vec2.new(7, 1), 1e-12)
	assert_almost_eq(model.scalar_projection(), sqrt(50.0), 1e-12)


func test_swapped_tail_and_head_are_those_of_the_other_vector() -> void:
	var model := _lecture()
	model.a_tail.set_xy(1, 2)
	model.is_swapped = true
	assert_vec2(model.onto_tail(), Vec2.new(1, 2), 0.0)
	assert_vec2(model.shadowed_tail(), Vec2.new(0, 0), 0.0)
	assert_vec2(model.shadowed_head(), Vec2.new(8, -6), 0.0)


func test_without_normalizing_all_is_too_big_by_the_length() -> void:
	var model := _lecture()
	model.normalizes = false
	assert_eq(model.scalar_projection(), 50.0)
	assert_vec2(model.vector_projection(), Vec2.new(400, -300), 0.0)
	assert_ne(model.rejection().dot(model.onto()), 0.0)


func test_a_zero_vector_has_no_shadow_and_casts_none() -> void:
	for letter: String in ["a", "b"]:
		var model := _lecture()
		var head: Vec2 = model.get(letter + "_head")
		head.set_xy(0, 0)
		assert_eq(model.scalar_projection(), 0.0)
		assert_vec2(model.vector_projection(), Vec2.new(0, 0), 0.0)
		assert_eq(model.angle_degrees(), 0.0)
		assert_eq(model.side(), 0)


func test_the_side_is_the_sign_of_the_cosine() -> void:
	for degrees: int in range(-175, 181, 5):
		var model := _lecture()
		model.set_signed_angle_degrees(degrees)
		if absi(degrees) != 90:
			assert_eq(model.side(), 1 if absi(degrees) < 90 else -1, str(degrees))


func test_a_right_angle_of_whole_numbers_is_exactly_on_neither_side() -> void:
	var model := _lecture()
	model.a_head.set_xy(3, 4)
	assert_eq(model.side(), 0)
	assert_almost_eq(model.angle_degrees(), 90.0, 1e-13)


func test_turning_keeps_length_and_tail_and_reaches_the_angle() -> void:
	for model: DotProductModel in _random_models():
		var length := model.shadowed().length()
		var tail := model.shadowed_tail().copy()
		model.set_signed_angle_degrees(-130.0)
		assert_almost_eq(model.signed_angle_degrees(), -130.0, 1e-11)
		assert_almost_eq(model.shadowed().length(), length, 1e-12)
		assert_vec2(model.shadowed_tail(), tail, 0.0)


func _lecture() -> DotProductModel:
	var model := DotProductModel.new()
	assert_no_refusal(model.take(DotProductModel.PRESETS["Lecture"]))
	return model


func _random_models() -> Array[DotProductModel]:
	var vectors := random_vectors(8, 4 * _COUNT, 10.0)
	var models: Array[DotProductModel] = []
	for i: int in _COUNT:
		var model := DotProductModel.new()
		model.a_tail = vectors[4 * i]
		model.a_head = vectors[4 * i + 1]
		model.b_tail = vectors[4 * i + 2]
		model.b_head = vectors[4 * i + 3]
		models.append(model)
	return models
