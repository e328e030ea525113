extends LabTest
## Objects are shared, values and copies are not; 64 bits against 32.


func test_a_second_name_moves_along_with_the_vec2() -> void:
	var model := ClassOrValueModel.new()
	model.remember()
	model.move_to(7.0, 1.0)
	assert_vec2(model.old, Vec2.new(7.0, 1.0), 0.0)
	assert_true(model.is_shared())


func test_the_vector2_leaves_its_old_value_behind() -> void:
	var model := ClassOrValueModel.new()
	model.remember()
	model.move_to(7.0, 1.0)
	assert_eq(model.value, Vector2(7.0, 1.0))
	assert_eq(model.old_value, Vector2(2.0, -3.0))


func test_a_copy_stays_behind() -> void:
	var model := ClassOrValueModel.new()
	model.copies = true
	model.remember()
	model.move_to(7.0, 1.0)
	assert_vec2(model.old, Vec2.new(2.0, -3.0), 0.0)
	assert_false(model.is_shared())


func test_a_stored_state_comes_back_with_its_sharing() -> void:
	for copies: bool in [false, true]:
		var model := ClassOrValueModel.new()
		model.copies = copies
		model.remember()
		model.move_to(4.0, 5.0)
		var again := ClassOrValueModel.new()
		again.from_dictionary(model.to_dictionary())
		assert_eq(again.to_dictionary(), model.to_dictionary())
		assert_eq(again.is_shared(), not copies)


func test_it_begins_with_the_old_place_remembered_and_both_moved() -> void:
	var model := ClassOrValueModel.new()
	model.copies = true
	model.remember_and_move(Vec2.new(1.0, 2.0), Vec2.new(3.0, 4.0))
	assert_vec2(model.old, Vec2.new(1.0, 2.0), 0.0)
	assert_vec2(model.position, Vec2.new(3.0, 4.0), 0.0)
	assert_eq([model.old_value, model.value], [Vector2(1.0, 2.0), Vector2(3.0, 4.0)])


func test_a_place_beyond_32_bits_is_refused() -> void:
	var stored := ClassOrValueModel.new().to_dictionary()
	assert_eq(ClassOrValueModel.new().problem_in(stored), "")
	stored["old"] = PackedFloat64Array([0.0, -2e38])
	assert_string_contains(ClassOrValueModel.new().problem_in(stored), "old must be within")


func test_as_many_names_are_counted_as_the_step_shows() -> void:
	assert_eq(ClassOrValueTexts.sharing(true, 0)[0], "one name, one object")
	assert_eq(ClassOrValueTexts.sharing(true, 1)[0], "two names, one object")
	assert_eq(ClassOrValueTexts.sharing(false, 1)[0], "two names, two objects")
	assert_eq(ClassOrValueTexts.sharing(true, 0)[1], "one name, one value")
	assert_eq(ClassOrValueTexts.sharing(true, 1)[1], "two names, two values")


func test_a_million_tenths_miss_by_a_thousand_in_32_bits_and_by_a_millionth_in_64() -> void:
	var count := 1_000_000
	assert_almost_eq(TenthSum.with_64_bits(count), TenthSum.exact(count), 2e-6)
	assert_gt(absf(TenthSum.with_32_bits(count) - TenthSum.exact(count)), 900.0)


func test_only_the_shared_vec2_changes_under_its_other_name() -> void:
	var expected: Dictionary[SharingExercise.Kind, float] = {
		SharingExercise.Kind.VEC2: 9.0,
		SharingExercise.Kind.VECTOR2: 3.0,
		SharingExercise.Kind.COPY: 3.0,
	}
	for kind in expected:
		var exercise := SharingExercise.new(kind, 3, 4, 9)
		assert_true(exercise.check([expected[kind]]).is_right, exercise.prompt)
		assert_false(exercise.check([12.0 - expected[kind]]).is_right, exercise.prompt)


func test_the_mistake_of_taking_an_assignment_for_a_copy_is_named() -> void:
	var verdict := SharingExercise.new(SharingExercise.Kind.VEC2, 3, 4, 9).check([3.0])
	assert_string_contains(verdict.sentence, "second name, not a copy")


func test_a_number_too_large_for_a_vector2_is_refused() -> void:
	var model := ClassOrValueModel.new()
	var before := model.to_dictionary()
	assert_string_contains(model.enter("x", 1e39), "must be within")
	assert_eq(model.to_dictionary(), before)
	assert_eq(model.enter("y", -1e38), "")
