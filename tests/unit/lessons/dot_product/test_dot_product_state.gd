extends LabTest
## The stored state of the lesson's model, as undo and reset use it.


func test_a_stored_state_comes_back_in_full() -> void:
	var stored := _changed().to_dictionary()
	var model := DotProductModel.new()
	model.from_dictionary(stored)
	assert_eq(model.to_dictionary(), stored)
	assert_vec2(model.a_tail, Vec2.new(1, 2), 0.0)
	assert_vec2(model.a_head, Vec2.new(3, 4), 0.0)
	assert_vec2(model.b_tail, Vec2.new(5, 6), 0.0)
	assert_vec2(model.b_head, Vec2.new(7, 8), 0.0)
	assert_true(model.is_swapped)
	assert_false(model.normalizes)


func test_a_stored_state_does_not_change_with_the_model() -> void:
	var model := _changed()
	var stored := model.to_dictionary()
	model.a_tail.set_xy(99, 99)
	model.normalizes = true
	assert_eq(stored, _changed().to_dictionary())


func test_a_model_does_not_change_a_state_that_it_was_given() -> void:
	var stored := _changed().to_dictionary()
	var model := DotProductModel.new()
	model.from_dictionary(stored)
	model.b_head.set_xy(99, 99)
	assert_eq(stored, _changed().to_dictionary())


func test_two_models_of_one_state_share_nothing() -> void:
	var stored := _changed().to_dictionary()
	var one := DotProductModel.new()
	var other := DotProductModel.new()
	one.from_dictionary(stored)
	other.from_dictionary(stored)
	one.a_head.set_xy(99, 99)
	assert_vec2(other.a_head, Vec2.new(3, 4), 0.0)


func test_a_and_b_are_given_as_new_vectors() -> void:
	var model := _changed()
	model.a().set_xy(99, 99)
	model.b().set_xy(99, 99)
	model.onto().set_xy(99, 99)
	assert_eq(model.to_dictionary(), _changed().to_dictionary())


func _changed() -> DotProductModel:
	var model := DotProductModel.new()
	model.a_tail.set_xy(1, 2)
	model.a_head.set_xy(3, 4)
	model.b_tail.set_xy(5, 6)
	model.b_head.set_xy(7, 8)
	model.is_swapped = true
	model.normalizes = false
	return model
