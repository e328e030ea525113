extends LabTest
## The model of the lesson on more dimensions: one dot product for any number of components.


func test_with_a_third_component_of_0_it_is_the_dot_product_of_the_lecture() -> void:
	assert_eq(ComponentLists.dot([7.0, 1.0, 0.0], [8.0, -6.0, 0.0]), 50.0)


func test_the_dot_products_of_the_lesson() -> void:
	var model := MoreDimensionsModel.new()
	assert_eq(model.products(), PackedFloat64Array([8, 12, -2]))
	assert_eq(model.dot(), 18.0)
	model.has_four = true
	assert_eq(model.dot(), 21.0)
	model.has_five = true
	assert_eq(model.dot(), 15.0)


func test_two_components_give_what_vec2_gives() -> void:
	var vectors := random_vectors(101, 200)
	for index: int in range(0, vectors.size(), 2):
		var one := vectors[index]
		var other := vectors[index + 1]
		assert_eq(ComponentLists.dot([one.x, one.y], [other.x, other.y]), one.dot(other))


func test_the_last_component_counts_only_with_four() -> void:
	var model := MoreDimensionsModel.new()
	model.b[3] = 1000.0
	assert_eq(model.dot(), 18.0)
	model.has_four = true
	assert_eq(model.dot(), 1018.0)


func test_the_sign_tells_the_angle_that_the_cosine_rule_gives() -> void:
	# Independent of products: |a - b|² against |a|² + |b|², by Pythagoras.
	var model := MoreDimensionsModel.new()
	model.has_four = true
	var vectors := random_vectors(102, 400)
	for index: int in range(0, vectors.size(), 4):
		model.a = [vectors[index].x, vectors[index].y, vectors[index + 1].x, vectors[index + 1].y]
		model.b = [
			vectors[index + 2].x, vectors[index + 2].y, vectors[index + 3].x, vectors[index + 3].y
		]
		var excess := 0.0
		for i: int in 4:
			excess += model.a[i] ** 2 + model.b[i] ** 2 - (model.a[i] - model.b[i]) ** 2
		assert_eq(model.side(), int(signf(excess)) as MoreDimensionsModel.Side)


func test_acute_right_and_obtuse() -> void:
	var model := MoreDimensionsModel.new()
	assert_eq(model.side(), MoreDimensionsModel.Side.ACUTE)
	model.b = [1.0, -2.0, -5.0, 0.0]
	assert_eq(model.side(), MoreDimensionsModel.Side.RIGHT)
	assert_eq(model.angle_degrees(), 90.0)
	model.b = [-3.0, 2.0, 1.0, -4.0]
	assert_eq(model.side(), MoreDimensionsModel.Side.OBTUSE)


func test_the_angle_of_the_space_diagonal_of_a_cube() -> void:
	var model := MoreDimensionsModel.new()
	model.a = [1.0, 1.0, 1.0, 1.0, 1.0]
	model.b = [1.0, 0.0, 0.0, 0.0, 0.0]
	assert_almost_eq(model.cosine(), 1.0 / sqrt(3.0), 1e-15)
	model.has_four = true
	assert_almost_eq(model.angle_degrees(), 60.0, 1e-13)
	model.has_five = true
	assert_almost_eq(model.cosine(), 1.0 / sqrt(5.0), 1e-15)


func test_parallel_vectors_make_no_angle_beyond_the_cosines_range() -> void:
	var model := MoreDimensionsModel.new()
	model.a = [0.1, 0.2, 0.3, 0.0]
	model.b = [0.3, 0.6, 0.9, 0.0]
	assert_eq(model.angle_degrees(), 0.0)


# Of 6.7e-8 degrees the arc cosine of a double knows nothing.
func test_a_tiny_angle_keeps_its_digits() -> void:
	var model := MoreDimensionsModel.new()
	model.a = [1000.0, 0.0, 0.0, 0.0]
	for tiny: float in [1e-6, -1e-6]:
		model.b = [signf(tiny) * 1000.0, tiny, 0.0, 0.0]
		var degrees := rad_to_deg(1e-9)
		var shown := model.angle_degrees() if tiny > 0.0 else 180.0 - model.angle_degrees()
		assert_almost_eq(shown, degrees, 1e-13)


func test_a_zero_vector_makes_no_angle() -> void:
	var model := MoreDimensionsModel.new()
	model.a = [0.0, 0.0, 0.0, 0.0]
	assert_eq(model.cosine(), 0.0)
	assert_null(model.exact_cosine())


func test_the_exact_dot_product_keeps_what_a_double_loses() -> void:
	var one: PackedFloat64Array = [1e6, 1.0, -1e6]
	var other: PackedFloat64Array = [1e6 + 1e-9, 1e-7, 1e6]
	var want := 1e6 * ((1e6 + 1e-9) - 1e6) + 1e-7
	assert_almost_eq(ComponentLists.exact_dot(one, other).to_float(), want, 1e-15)


func test_a_component_is_put_into_its_own_place() -> void:
	var model := MoreDimensionsModel.new()
	assert_eq(model.set_component("b", 2, 9.0), "")
	assert_eq(model.b, PackedFloat64Array([2, -4, 9, 3, -2]))
	assert_eq(model.a, PackedFloat64Array([4, -3, 2, 1, 3]))


func test_a_component_out_of_range_is_refused_and_nothing_changes() -> void:
	var model := MoreDimensionsModel.new()
	assert_string_contains(model.set_component("a", 0, 2e6), "from 1e-6 to 1e6")
	assert_string_contains(model.set_component("a", 0, 1e-7), "1e−7 cannot be")
	assert_eq(model.a[0], 4.0)
	assert_eq(model.set_component("a", 0, 0.0), "")


func test_what_is_stored_is_not_shared_and_can_be_put_back() -> void:
	var model := MoreDimensionsModel.new()
	var stored := model.to_dictionary()
	assert_no_refusal(model.set_component("a", 0, 77.0))
	model.has_four = true
	model.view.turn(1.0, 0.2)
	model.from_dictionary(stored)
	assert_eq(model.to_dictionary(), MoreDimensionsModel.new().to_dictionary())
	assert_no_refusal(model.set_component("a", 0, 77.0))
	assert_eq(stored, MoreDimensionsModel.new().to_dictionary())


func test_a_link_with_four_components_leaves_the_fifth() -> void:
	var model := MoreDimensionsModel.new()
	var link := LessonLink.read("a=1,2,3,4&has_four=true", model.link_state())
	assert_eq(link.problem, "")
	model.from_dictionary(model.state_of_link(link.state))
	assert_eq(model.counted_a(), PackedFloat64Array([1, 2, 3, 4]))
	assert_eq(model.a[4], 3.0)
	link = LessonLink.read("fifth=7,8&has_five=true", model.link_state())
	model.from_dictionary(model.state_of_link(link.state))
	assert_eq(model.counted_a(), PackedFloat64Array([1, 2, 3, 4, 7]))
	assert_eq(model.b[4], 8.0)


func test_a_fifth_component_out_of_range_is_refused() -> void:
	var stored := MoreDimensionsModel.new().to_dictionary()
	stored["fifth"] = PackedFloat64Array([1.0, 1e7])
	assert_string_contains(MoreDimensionsModel.new().problem_in(stored), "1e7 cannot be")


func test_a_view_keeps_lengths_in_its_plane() -> void:
	var view := Axonometry.new()
	for step: Vec2 in random_vectors(103, 50):
		view.turn(step.x, step.y / 100.0)
		var in_space := view.step_in_space(step)
		assert_vec2(view.seen_at(in_space[0], in_space[1], in_space[2]), step, 1e-12)
		assert_almost_eq(ComponentLists.length(in_space), step.length(), 1e-12)


func test_a_view_from_the_front_shows_x_and_y_as_they_are() -> void:
	var view := Axonometry.new()
	view.turn(-view.yaw, -view.pitch)
	assert_vec2(view.seen_at(3.0, -4.0, 99.0), Vec2.new(3, -4), 1e-15)


func test_a_view_cannot_be_turned_upside_down() -> void:
	var view := Axonometry.new()
	view.turn(0.0, 10.0)
	assert_eq(view.pitch, Axonometry.STEEPEST)
	view.turn(0.0, -10.0)
	assert_eq(view.pitch, -Axonometry.STEEPEST)
