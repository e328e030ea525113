extends LabTest
## What the lesson on normals computes, with the numbers of the lecture.

var _model: NormalsModel


func before_each() -> void:
	_model = NormalsModel.new()


func test_the_normals_of_the_lecture() -> void:
	_assert_normal(Vec2.new(3.0, 1.0), Vec2.new(-1.0, 3.0))
	_assert_normal(Vec2.new(3.0, -2.0), Vec2.new(2.0, 3.0))
	_assert_normal(Vec2.new(3.0, -4.0), Vec2.new(4.0, 3.0))


func test_the_unit_normal_of_the_lecture_has_fifths() -> void:
	_lay(Vec2.new(), Vec2.new(3.0, -4.0))
	assert_eq(_model.normal().length(), 5.0)
	assert_vec2(_model.unit(), Vec2.new(0.8, 0.6), EPSILON)


func test_the_normal_is_a_quarter_turn_from_the_x_axis_to_the_y_axis() -> void:
	for v: Vec2 in random_vectors(1, 60):
		_lay(Vec2.new(), v)
		var angle := atan2(v.y, v.x) + PI / 2.0
		var size := sqrt(v.x * v.x + v.y * v.y)
		assert_vec2(_model.normal(), Vec2.new(size * cos(angle), size * sin(angle)), 1e-12)


func test_both_normals_are_perpendicular_and_opposite() -> void:
	for v: Vec2 in random_vectors(2, 60):
		_lay(Vec2.new(), v)
		assert_eq(v.x * _model.normal().x + v.y * _model.normal().y, 0.0)
		assert_vec2(_model.opposite(), _model.normal().scaled(-1.0), 0.0)


func test_the_scaled_normal_is_as_many_pixels_long_as_it_is_scaled() -> void:
	for v: Vec2 in random_vectors(3, 30):
		_lay(Vec2.new(), v)
		_model.times = 60.0
		assert_almost_eq(_model.scaled().length(), 60.0, 1e-12)
		assert_gt(_model.scaled().dot(_model.normal()), 0.0)


func test_moving_the_line_leaves_its_normal_unchanged() -> void:
	_lay(Vec2.new(), Vec2.new(3.0, 1.0))
	var unit := _model.unit()
	_lay(Vec2.new(-4.0, 2.0), Vec2.new(3.0, 1.0))
	assert_vec2(_model.unit(), unit, 0.0)
	assert_eq(_model.change_since(Vec2.new(), Vec2.new(3.0, 1.0)), NormalsModel.Change.MOVED)


func test_the_four_changes_are_told_apart() -> void:
	_lay(Vec2.new(1.0, 1.0), Vec2.new(6.0, 2.0))
	assert_eq(_since(Vec2.new(1.0, 1.0), Vec2.new(6.0, 2.0)), NormalsModel.Change.NONE)
	assert_eq(_since(Vec2.new(1.0, 2.0), Vec2.new(6.0, 2.0)), NormalsModel.Change.MOVED)
	assert_eq(_since(Vec2.new(1.0, 1.0), Vec2.new(3.0, 1.0)), NormalsModel.Change.STRETCHED)
	assert_eq(_since(Vec2.new(1.0, 1.0), Vec2.new(-3.0, -1.0)), NormalsModel.Change.TURNED)


func test_the_normal_turns_by_as_much_as_the_line() -> void:
	_lay(Vec2.new(), Vec2.new(0.0, 2.0))
	assert_almost_eq(_model.turned_degrees(Vec2.new(2.0, 0.0)), 90.0, 1e-12)


func test_a_zero_line_has_zero_normals() -> void:
	_lay(Vec2.new(5.0, 5.0), Vec2.new())
	assert_vec2(_model.normal(), Vec2.new(), 0.0)
	assert_vec2(_model.unit(), Vec2.new(), 0.0)
	assert_vec2(_model.scaled(), Vec2.new(), 0.0)


func test_a_stored_line_comes_back_and_shares_nothing() -> void:
	_lay(Vec2.new(1.0, 2.0), Vec2.new(3.0, 4.0))
	_model.times = -7.0
	_model.mistake = 9
	var other := NormalsModel.new()
	other.from_dictionary(_model.to_dictionary())
	assert_eq(other.to_dictionary(), _model.to_dictionary())
	other.start.x = 99.0
	assert_eq(_model.start.x, 1.0)


func test_a_number_changes_its_own_component_and_a_new_start_keeps_v() -> void:
	_lay(Vec2.new(1.0, 2.0), Vec2.new(3.0, 4.0))
	assert_no_refusal(_model.enter("vx", 5.0))
	assert_no_refusal(_model.enter("sy", -6.0))
	assert_no_refusal(_model.enter("k", 9.0))
	assert_vec2(_model.start, Vec2.new(1.0, -6.0), 0.0)
	assert_vec2(_model.v(), Vec2.new(5.0, 4.0), 0.0)
	assert_eq(_model.times, 9.0)


func test_a_mistake_without_a_number_in_the_gallery_is_refused() -> void:
	assert_eq(_model.take({"mistake": NormalsMistakes.CUT_LENGTH}), "")
	assert_string_contains(_model.take({"mistake": 8}), "mistake must be one of 0, 9, 6, 7")
	assert_eq(_model.mistake, NormalsMistakes.CUT_LENGTH)


func test_the_exact_error_of_a_unit_normal_is_below_a_unit_in_the_last_place() -> void:
	for v: Vec2 in random_vectors(4, 30):
		assert_lt(ExactNormal.error_of(v.normal(), v), 2.0 * EPSILON)
	assert_almost_eq(ExactNormal.error_of(Vec2.new(0.8, 0.5), Vec2.new(3.0, -4.0)), 0.1, 1e-12)


func test_the_way_by_angles_agrees_but_for_rounding() -> void:
	for v: Vec2 in random_vectors(5, 30):
		assert_vec2(NormalByAngle.unit(v), v.normal(), 1e-14)


func _since(old_start: Vec2, old_v: Vec2) -> NormalsModel.Change:
	return _model.change_since(old_start, old_v)


func _assert_normal(v: Vec2, wanted: Vec2) -> void:
	_lay(Vec2.new(), v)
	assert_vec2(_model.normal(), wanted, 0.0)


func _lay(start: Vec2, v: Vec2) -> void:
	_model.start = start
	_model.end = start.plus(v)
