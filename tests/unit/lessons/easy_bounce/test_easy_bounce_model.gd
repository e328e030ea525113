extends LabTest
## What the lesson on the easy bounce computes: the easy program beside the normal, frame by frame.

const _TILTS: Array[float] = [-45.0, -30.0, -7.5, 10.0, 30.0, 45.0]

var _model: EasyBounceModel


func before_each() -> void:
	_model = EasyBounceModel.new()


func test_on_a_level_floor_all_three_errors_are_exactly_0() -> void:
	_assert_no_error()


func test_on_an_upright_wall_all_three_errors_are_exactly_0() -> void:
	_model.swap_axes()
	_assert_no_error()


func test_on_a_level_floor_no_ball_has_an_error_beyond_rounding() -> void:
	for point: Vec2 in random_vectors(3, 60, 200.0):
		_model.ball = Ball.new(point, 60.0, Vec2.new(point.y, point.x))
		assert_lt(absf(_model.distance_error(_model.ball)), 1e-12)
		assert_lt(_model.position_error(_model.ball), 1e-12)
		assert_lt(_model.velocity_error(_model.ball), 1e-12)


# The cosine of the tilt, by elementary geometry, not by any normal.
func test_the_shortest_distance_is_the_straight_one_times_the_cosine_of_the_tilt() -> void:
	for is_wall: bool in [false, true]:
		_model.is_wall = is_wall
		for tilt in _TILTS:
			_model.tilt_degrees = tilt
			for point: Vec2 in random_vectors(5, 20, 150.0):
				var wanted := _model.straight_distance(point) * cos(deg_to_rad(tilt))
				assert_almost_eq(_model.shortest_distance(point), wanted, 1e-10)


func test_both_feet_lie_on_the_line() -> void:
	for is_wall: bool in [false, true]:
		_model.is_wall = is_wall
		for tilt in _TILTS:
			_model.tilt_degrees = tilt
			for point: Vec2 in random_vectors(6, 10, 150.0):
				assert_almost_eq(_off_line(_model.straight_foot(point)), 0.0, 1e-10)
				assert_almost_eq(_off_line(_model.shortest_foot(point)), 0.0, 1e-10)


func test_put_back_straight_on_a_tilted_line_the_ball_still_overlaps() -> void:
	for tilt in _TILTS:
		_model.tilt_degrees = tilt
		var easy := _model.easy_result(_model.ball)
		var wanted := -60.0 * (1.0 - cos(deg_to_rad(tilt)))
		assert_almost_eq(LineDistance.gap(easy, _model.line()), wanted, 1e-10)


func test_put_back_along_the_normal_the_ball_just_touches() -> void:
	for tilt in _TILTS:
		_model.tilt_degrees = tilt
		var right := _model.right_result(_model.ball)
		assert_almost_eq(LineDistance.gap(right, _model.line()), 0.0, 1e-10)


# Flipping and reflecting differ by a turn of twice the tilt, so the heads by a chord of that angle.
func test_the_flipped_velocity_is_off_by_the_chord_of_twice_the_tilt() -> void:
	for tilt in _TILTS:
		_model.tilt_degrees = tilt
		_model.ball.velocity = Vec2.new(0.0, 50.0)
		var chord := 2.0 * 50.0 * absf(sin(deg_to_rad(tilt)))
		assert_almost_eq(_model.velocity_error(_model.ball), chord, 1e-10)


func test_on_a_tilted_line_the_easy_program_notices_the_hit_too_late() -> void:
	_model.tilt_degrees = 30.0
	_model.ball.position = Vec2.new(0.0, -24.0)
	assert_false(_model.easy_detects(_model.ball))
	assert_true(LineDistance.is_overlapping(_model.ball, _model.line()))
	assert_vec2(_model.easy_result(_model.ball).position, _model.ball.position, 0.0)


func test_a_ball_that_moves_away_already_is_put_back_and_not_flipped() -> void:
	_model.ball.velocity = Vec2.new(20.0, -48.0)
	assert_vec2(_model.easy_result(_model.ball).velocity, Vec2.new(20.0, -48.0), 0.0)
	assert_vec2(_model.right_result(_model.ball).velocity, Vec2.new(20.0, -48.0), 0.0)


func test_the_results_leave_the_ball_as_it_was() -> void:
	_model.easy_result(_model.ball)
	_model.right_result(_model.ball)
	assert_vec2(_model.ball.position, Vec2.new(0.0, 4.0), 0.0)
	assert_vec2(_model.ball.velocity, Vec2.new(20.0, 48.0), 0.0)


func _assert_no_error() -> void:
	assert_eq(_model.distance_error(_model.ball), 0.0)
	assert_eq(_model.position_error(_model.ball), 0.0)
	assert_eq(_model.velocity_error(_model.ball), 0.0)


# How far a point is from the line, by the equation of the line.
func _off_line(point: Vec2) -> float:
	var angle := deg_to_rad(_model.tilt_degrees)
	var x := point.x - _model.pivot.x
	var y := point.y - _model.pivot.y
	return x * cos(angle) + y * sin(angle) if _model.is_wall else y * cos(angle) - x * sin(angle)
