extends LabTest
## The exact impact under constant acceleration with a point, or of two balls.

var _table := ImpactTable.new("ball_segment_gravity")
var _pairs := ImpactTable.new("ball_ball")
var _solver := AcceleratedPointImpactFinder.new()


func test_an_end_that_is_touched_first_is_touched_alone_at_the_same_time() -> void:
	var errors := PackedFloat64Array()
	for row: int in _table.size():
		var feature := int(_table.at(row, "feature"))
		if feature >= 2:
			var end := "a" if feature == 2 else "b"
			_fly(_table, row)
			var is_hit := _touches(_table.at(row, end + "x"), _table.at(row, end + "y"))
			errors.append(_table.time_error(row, _solver.time) if is_hit else INF)
	assert_all_at_most(errors, 4.0)


func test_without_acceleration_it_finds_the_impacts_of_two_balls() -> void:
	var wrong := PackedInt32Array()
	var worst := WorstErrors.new()
	for row: int in _pairs.size():
		_solver.set_flight(
			_pairs.at(row, "p1x") - _pairs.at(row, "p2x"),
			_pairs.at(row, "p1y") - _pairs.at(row, "p2y"),
			_pairs.at(row, "v1x") - _pairs.at(row, "v2x"),
			_pairs.at(row, "v1y") - _pairs.at(row, "v2y"),
			0.0,
			0.0,
			_pairs.at(row, "r1") + _pairs.at(row, "r2")
		)
		var is_hit := _touches(0.0, 0.0)
		if is_hit != _pairs.is_hit(row):
			wrong.append(row)
		elif is_hit:
			worst.note(_pairs.family(row), _pairs.time_error(row, _solver.time))
	assert_eq(wrong, PackedInt32Array())
	assert_all_at_most(worst.values(), 4.0)


func test_a_ball_thrown_up_meets_another_that_falls() -> void:
	# Relative motion: 100 px apart, 40 px/s towards each other, accelerations 6 and -2 px/s².
	_solver.set_flight(0, -100, 0, 40, 0, -8, 10)
	# The distance 100 - 40 t + 4 t² falls to 0 at 5 s. It is 10, the radius, at 5 - sqrt(2.5) s.
	assert_true(_touches(0, 0))
	assert_almost_eq(_solver.time, 5.0 - sqrt(2.5), 1e-15)
	assert_eq([_solver.normal_x, _solver.normal_y], [0.0, -1.0])


func test_the_first_of_two_entries_counts() -> void:
	# Thrown up through the circle, the ball enters it from below, leaves, and falls back into it.
	_solver.set_flight(0, 30, 0, -40, 0, 10, 10)
	assert_true(_touches(0, 0))
	assert_almost_eq(_solver.time, 4.0 - 2.0 * sqrt(3.0), 1e-15)
	# 1 s later it starts inside: only the entry from above is still to come.
	_solver.set_flight(0, -5, 0, -30, 0, 10, 10)
	assert_true(_touches(0, 0))
	assert_almost_eq(_solver.time, 3.0 + sqrt(8.0), 1e-14)


func test_a_ball_pressed_along_the_point_that_it_touches_does_not_impact() -> void:
	# It touches, moves along and is pulled inwards. So it overlaps until it falls out below.
	_solver.set_flight(-60, -25, -5, 12, 0, 687.947606674021, 65)
	assert_false(_touches(0, 0))


func test_a_ball_far_away_across_the_acceleration_is_a_miss() -> void:
	_solver.set_flight(0, 0, 0, 5, 0, 10, 3)
	assert_false(_touches(3.5, 100))
	assert_true(_touches(2.5, 100))


func test_an_acceleration_that_is_only_rounding_changes_nothing() -> void:
	_solver.set_flight(-50, 1, 20, 0, 0, 0, 5)
	_touches(0, 0)
	var straight := _solver.time
	for tiny: float in [1e-300, 1e-160, 1e-30, -1e-20]:
		_solver.set_flight(-50, 1, 20, 0, tiny, tiny, 5)
		assert_true(_touches(0, 0))
		assert_almost_eq(_solver.time, straight, 1e-15)


func test_a_ball_at_rest_on_a_point_or_beside_it_meets_nothing() -> void:
	_solver.set_flight(0, -5, 0, 0, 0, 0, 5)
	assert_false(_touches(0, 0))
	_solver.set_flight(0, -9, 0, 0, 0, 0, 5)
	assert_false(_touches(0, 0))


func test_a_horizon_hides_what_comes_later() -> void:
	_solver.set_flight(0, -42, 0, 0, 0, 4, 10)
	assert_false(_solver.with_point(0, 0, 3.9))
	assert_true(_solver.with_point(0, 0, 4.1))
	assert_eq(_solver.time, 4.0)


func _fly(table: ImpactTable, row: int) -> void:
	_solver.set_flight(
		table.at(row, "px"),
		table.at(row, "py"),
		table.at(row, "vx"),
		table.at(row, "vy"),
		table.at(row, "gx"),
		table.at(row, "gy"),
		table.at(row, "r")
	)


func _touches(cx: float, cy: float) -> bool:
	return _solver.with_point(cx, cy, INF)
