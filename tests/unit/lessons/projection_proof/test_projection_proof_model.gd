extends LabTest
## The model of the proof: both vectors turned until b lies on the x axis.


func test_the_turn_of_the_lecture() -> void:
	var model := ProjectionProofModel.new()
	assert_vec2(model.turned(model.a), Vec2.new(5, 5), 1e-14)
	assert_vec2(model.turned(model.b), Vec2.new(10, 0), 1e-14)


func test_before_the_turn_nothing_has_moved() -> void:
	var model := ProjectionProofModel.new()
	model.turned_share = 0.0
	assert_vec2(model.turned(model.a), Vec2.new(7, 1), 0.0)
	assert_vec2(model.turned(model.b), Vec2.new(8, -6), 0.0)


func test_half_way_b_has_half_its_angle() -> void:
	var model := ProjectionProofModel.new()
	model.turned_share = 0.5
	assert_almost_eq(model.turned(model.b).angle_radians(), atan2(-6, 8) / 2.0, 1e-15)
	assert_almost_eq(model.turned(model.b).length(), 10.0, 1e-14)


func test_the_share_of_the_turn_stays_within_0_and_1() -> void:
	var model := ProjectionProofModel.new()
	model.turned_share = 1.7
	assert_eq(model.turned_share, 1.0)
	model.turned_share = -0.1
	assert_eq(model.turned_share, 0.0)


func test_cosine_and_sine_stand_in_the_triangle_of_b() -> void:
	var model := ProjectionProofModel.new()
	assert_almost_eq(model.cosine(), 0.8, EPSILON)
	assert_almost_eq(model.sine(), -0.6, EPSILON)


func test_both_sides_of_the_proof_are_5_in_the_lecture() -> void:
	var model := ProjectionProofModel.new()
	assert_almost_eq(model.x_of_turned_a(), 5.0, 4.0 * EPSILON)
	assert_almost_eq(model.dot_with_unit(), 5.0, 4.0 * EPSILON)
	assert_eq(model.units_apart(), 0.0)


func test_the_pair_named_one_bit_is_one_unit_apart() -> void:
	assert_eq(_model(Vec2.new(5, 1), Vec2.new(3, 4)).units_apart(), 1.0)


func test_both_sides_agree_for_any_vectors() -> void:
	var errors := PackedFloat64Array()
	var vectors := random_vectors(151, 400)
	for i: int in range(0, 400, 2):
		var model := _model(vectors[i], vectors[i + 1])
		var scale := vectors[i].length()
		errors.append(absf(model.x_of_turned_a() - model.dot_with_unit()) / scale)
		# By the law of cosines: 2 |a| |b| cos = |a|^2 + |b|^2 - |a - b|^2.
		var apart := vectors[i].distance_to(vectors[i + 1])
		var both := vectors[i].length_squared() + vectors[i + 1].length_squared()
		var shadow := (both - apart * apart) / (2.0 * vectors[i + 1].length())
		errors.append(absf(model.dot_with_unit() - shadow) / (both / vectors[i + 1].length()))
	assert_all_at_most(errors, 8.0 * EPSILON)


func test_turning_keeps_lengths_and_the_angle_between() -> void:
	var vectors := random_vectors(152, 100)
	for i: int in range(0, 100, 2):
		var model := _model(vectors[i], vectors[i + 1])
		model.turned_share = i / 100.0
		var a := model.turned(model.a)
		assert_almost_eq(a.length(), model.a.length(), 1e-13)
		assert_almost_eq(a.dot(model.turned(model.b)), model.a.dot(model.b), 1e-11)


func test_a_turned_head_that_is_dragged_gives_the_vector_back() -> void:
	var model := ProjectionProofModel.new()
	model.set_turned_a(Vec2.new(10, 0))
	assert_vec2(model.a, Vec2.new(8, -6), 1e-14)


func test_the_turned_b_can_be_made_longer_but_not_turned() -> void:
	var model := ProjectionProofModel.new()
	model.set_reach_of_turned_b(Vec2.new(5, 3))
	assert_vec2(model.b, Vec2.new(4, -3), 1e-14)
	model.set_reach_of_turned_b(Vec2.new(-5, 0))
	assert_vec2(model.b, Vec2.new(4, -3), 1e-14, "behind the tail is not taken")


func test_a_zero_b_has_no_direction_and_casts_no_shadow() -> void:
	var model := _model(Vec2.new(7, 1), Vec2.zero())
	assert_false(model.has_direction())
	assert_eq(model.x_of_turned_a(), 0.0)
	assert_eq(model.dot_with_unit(), 0.0)


func test_a_typed_number_changes_its_own_component() -> void:
	var model := _model(Vec2.new(1, 2), Vec2.new(3, 4))
	assert_no_refusal(model.enter("ay", -5.0))
	assert_no_refusal(model.enter("bx", 6.0))
	assert_vec2(model.a, Vec2.new(1, -5), 0.0)
	assert_vec2(model.b, Vec2.new(6, 4), 0.0)


func test_what_is_stored_can_be_put_back() -> void:
	var stored := _model(Vec2.new(1, 2), Vec2.new(-3, 4)).to_dictionary()
	var model := ProjectionProofModel.new()
	model.from_dictionary(stored)
	assert_vec2(model.a, Vec2.new(1, 2), 0.0)
	assert_vec2(model.b, Vec2.new(-3, 4), 0.0)


func _model(a: Vec2, b: Vec2) -> ProjectionProofModel:
	var model := ProjectionProofModel.new()
	model.a = a.copy()
	model.b = b.copy()
	return model
