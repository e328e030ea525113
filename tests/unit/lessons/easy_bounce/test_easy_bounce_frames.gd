extends LabTest
## The frames of the lesson on the easy bounce: forward, backward, and by which program.

var _model: EasyBounceModel


func before_each() -> void:
	_model = EasyBounceModel.new()


func test_before_the_impact_the_ball_flies_straight() -> void:
	assert_eq(_model.first_frame(), -4)
	assert_vec2(_model.moved_ball(-2).position, Vec2.new(-40.0, -92.0), 0.0)


func test_after_the_impact_it_leaves_as_it_came_mirrored() -> void:
	for in_frame: int in range(1, 6):
		var place := _model.ball_after(in_frame, _model.easy_result).position
		assert_vec2(place, Vec2.new(20.0 * in_frame, -20.0 - 48.0 * in_frame), 1e-12)


func test_on_a_level_floor_both_programs_go_the_same_way() -> void:
	for in_frame: int in range(-4, 6):
		var easy := _model.ball_after(in_frame, _model.easy_result)
		var right := _model.ball_after(in_frame, _model.right_result)
		assert_vec2(easy.position, right.position, 1e-12)


func test_no_frame_before_the_impact_overlaps_the_line() -> void:
	for tilt: float in [-45.0, -20.0, 0.0, 20.0, 45.0]:
		_model.tilt_degrees = tilt
		for in_frame: int in range(_model.first_frame(), 0):
			assert_false(LineDistance.is_overlapping(_model.moved_ball(in_frame), _model.line()))


func test_a_ball_that_overlapped_in_the_frame_before_has_no_frames_before() -> void:
	_model.ball.velocity = Vec2.new(1.0, 2.0)
	assert_eq(_model.first_frame(), 0)


func test_a_step_and_a_step_back_lead_to_the_very_same_ball() -> void:
	_model.tilt_degrees = 23.0
	for start: int in 10:
		var before := _model.moved_ball(_model.frame())
		_model.advance(1.0)
		assert_ne(_model.moved_ball(_model.frame()).position.x, before.position.x)
		_model.advance(-1.0)
		var again := _model.moved_ball(_model.frame())
		assert_true(same_bits(again.position.x, before.position.x))
		assert_true(same_bits(again.position.y, before.position.y))
		_model.advance(1.0)


func test_after_the_last_frame_comes_the_first_one_and_the_other_way_round() -> void:
	_model.advance(4.0)
	assert_eq(_model.frame(), 4)
	_model.advance(1.0)
	assert_eq(_model.frame(), -4)
	_model.advance(-1.0)
	assert_eq(_model.frame(), 4)


func test_parts_of_a_frame_add_up() -> void:
	for part: int in 4:
		_model.advance(0.25)
		assert_eq(_model.frame(), 0 if part < 3 else 1)


func test_who_takes_hold_of_the_ball_takes_the_one_of_the_shown_frame() -> void:
	_model.advance(2.0)
	var shown := _model.moved_ball(2)
	_model.take_hold()
	assert_eq(_model.frame(), 0)
	assert_vec2(_model.ball.position, shown.position, 0.0)
	assert_vec2(_model.ball.velocity, shown.velocity, 0.0)


func test_the_two_axes_change_places_and_back() -> void:
	_model.tilt_degrees = 20.0
	var floor_error := _model.position_error(_model.ball)
	_model.swap_axes()
	assert_true(_model.is_wall)
	assert_vec2(_model.ball.position, Vec2.new(4.0, 0.0), 0.0)
	assert_almost_eq(_model.position_error(_model.ball), floor_error, 1e-12)
	_model.swap_axes()
	assert_eq(_model.tilt_degrees, 20.0, "as it was before both changes")


func test_a_stored_set_up_comes_back_and_shares_nothing() -> void:
	_model.swap_axes()
	_model.tilt_degrees = -12.5
	var stored := _model.to_dictionary()
	var other := EasyBounceModel.new()
	other.from_dictionary(stored)
	assert_eq(other.to_dictionary(), stored)
	other.ball.position.x = 99.0
	assert_eq(_model.ball.position.x, 4.0)


func test_a_number_is_set_in_the_shown_frame_or_refused() -> void:
	_model.advance(2.0)
	var shown := _model.moved_ball(2)
	assert_string_contains(_model.enter("r", 201.0), "at most 200")
	assert_eq([_model.frame(), _model.ball.radius], [2, 60.0])
	assert_eq(_model.enter("vx", 7.0), "")
	assert_eq(_model.frame(), 0)
	assert_vec2(_model.ball.position, shown.position, 0.0)
	assert_vec2(_model.ball.velocity, Vec2.new(7.0, shown.velocity.y), 0.0)


func test_a_stored_radius_or_tilt_out_of_range_is_refused() -> void:
	var stored := _model.to_dictionary()
	assert_eq(_model.problem_in(stored), "")
	stored["tilt_degrees"] = 46.0
	assert_string_contains(_model.problem_in(stored), "not 46°")
	stored["ball"] = PackedFloat64Array([0.0, 0.0, 0.0, 0.0, 0.0])
	assert_string_contains(_model.problem_in(stored), "r must be above 0")


func test_a_dragged_end_tilts_by_whole_degrees_and_never_too_far() -> void:
	var right_end := _model.pivot.plus(Vec2.unit_degrees(17.2).scaled(150.0))
	var left_end := _model.pivot.plus(Vec2.unit_degrees(180.0 - 8.4).scaled(90.0))
	assert_eq(_model.tilt_toward(right_end, true), 17.0)
	assert_eq(_model.tilt_toward(left_end, false), -8.0)
	assert_eq(_model.tilt_toward(Vec2.new(10.0, 300.0), true), 45.0)


func test_a_radius_or_tilt_out_of_range_is_refused_with_the_value_and_the_range() -> void:
	assert_eq(
		EasyBounceModel.number_problem("r", -5.0), "r must be above 0 and at most 200, not −5."
	)
	assert_eq(
		EasyBounceModel.number_problem("tilt", 60.0),
		"The tilt must be within −45° and 45°, not 60°."
	)
	assert_eq(EasyBounceModel.number_problem("tilt", -45.0), "")
	assert_eq(EasyBounceModel.number_problem("px", -5.0), "")
