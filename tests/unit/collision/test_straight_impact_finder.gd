extends LabTest
## The exact impact in straight flight, against 4000 answers that were computed with 60 digits.

const _TIME_BOUND := 4.0
const _NORMAL_BOUND := 4.0

var _table := ImpactTable.new("ball_segment")
var _solver := StraightImpactFinder.new()


func test_hit_or_miss_agrees_in_every_row() -> void:
	var wrong := PackedInt32Array()
	for row: int in _table.size():
		if _solve(row) != _table.is_hit(row):
			wrong.append(row)
	assert_eq(wrong, PackedInt32Array())


func test_the_time_is_right_to_the_last_bits() -> void:
	var worst := WorstErrors.new()
	for row: int in _table.size():
		if _solve(row) and _table.is_hit(row):
			var error := _table.time_error(row, _solver.time)
			worst.note(_table.family(row), error)
	gut.p("worst error of the time, straight flight: %s" % worst)
	assert_all_at_most(worst.values(), _TIME_BOUND)


func test_the_normal_is_right_to_the_last_bits() -> void:
	var worst := WorstErrors.new()
	for row: int in _table.size():
		if _solve(row) and _table.is_hit(row):
			var error := _normal_error(row)
			worst.note(_table.family(row), error)
	gut.p("worst error of the normal, straight flight: %s" % worst)
	assert_all_at_most(worst.values(), _NORMAL_BOUND)


func test_the_feature_is_the_one_that_is_touched() -> void:
	var wrong := PackedInt32Array()
	for row: int in _table.size():
		# Features 1, 2, 3 in the file are line, start, end. At a boundary both are right.
		if _solve(row) and _table.is_hit(row) and _table.family(row) == "random":
			if _solver.feature != int(_table.at(row, "feature")) - 1:
				wrong.append(row)
	assert_eq(wrong, PackedInt32Array())


func test_the_segment_turned_round_gives_the_same_impact() -> void:
	var differences := PackedFloat64Array()
	for row: int in _table.size():
		if _solve(row):
			var time := _solver.time
			var bound := EPSILON * maxf(_table.at(row, "condition"), time)
			_solve_turned(row)
			differences.append(absf(_solver.time - time) / bound if bound > 0.0 else _solver.time)
	assert_all_at_most(differences, _TIME_BOUND)


func test_a_ball_at_rest_meets_nothing() -> void:
	assert_false(_solver.with_segment(0, 1, 0, 0, 5, -10, 0, 10, 0))
	assert_false(_solver.with_point(0, 1, 0, 0, 5, 0, 0))


func test_a_touching_ball_bounces_only_if_it_approaches() -> void:
	assert_true(_solver.with_segment(0, 5, 3, 1e-300, 5, 10, 0, -10, 0) == false)
	assert_true(_solver.with_segment(0, 5, 3, -1, 5, 10, 0, -10, 0))
	assert_eq([_solver.time, _solver.normal_x, _solver.normal_y], [0.0, 0.0, 1.0])


func test_a_centre_on_the_line_is_stopped_from_either_side() -> void:
	assert_true(_solver.with_segment(0, 0, 1, -2, 5, -10, 0, 10, 0))
	assert_eq(_solver.normal_y, 1.0)
	assert_true(_solver.with_segment(0, 0, 1, 2, 5, -10, 0, 10, 0))
	assert_eq(_solver.normal_y, -1.0)


func test_it_agrees_with_the_lecture_where_both_are_asked_for_one_frame() -> void:
	var vectors := random_vectors(512, 1600)
	var differences := PackedFloat64Array()
	for index: int in range(0, vectors.size(), 4):
		differences.append(_difference_from_lecture(vectors.slice(index, index + 4)))
	assert_all_at_most(differences, 1e-9)


# By how much their times differ; 0 if neither finds an impact within one second.
func _difference_from_lecture(four: Array[Vec2]) -> float:
	var segment := LineSegment.new(four[2], four[3])
	var impact := SegmentImpact.with_segment(four[0], four[1], 5.0, segment)
	var is_hit := _solver.with_segment(
		four[0].x, four[0].y, four[1].x, four[1].y, 5, four[2].x, four[2].y, four[3].x, four[3].y
	)
	if impact.hit != (is_hit and _solver.time <= 1.0):
		return INF
	return absf(impact.fraction - _solver.time) if impact.hit else 0.0


func _solve(row: int) -> bool:
	return _solver.with_segment(
		_table.at(row, "px"),
		_table.at(row, "py"),
		_table.at(row, "vx"),
		_table.at(row, "vy"),
		_table.at(row, "r"),
		_table.at(row, "ax"),
		_table.at(row, "ay"),
		_table.at(row, "bx"),
		_table.at(row, "by")
	)


func _solve_turned(row: int) -> bool:
	return _solver.with_segment(
		_table.at(row, "px"),
		_table.at(row, "py"),
		_table.at(row, "vx"),
		_table.at(row, "vy"),
		_table.at(row, "r"),
		_table.at(row, "bx"),
		_table.at(row, "by"),
		_table.at(row, "ax"),
		_table.at(row, "ay")
	)


func _normal_error(row: int) -> float:
	var lengths: PackedFloat64Array = [
		Vec2.new(_table.at(row, "vx"), _table.at(row, "vy")).length(),
		Vec2.new(_table.at(row, "px"), _table.at(row, "py")).length(),
		Vec2.new(_table.at(row, "ax"), _table.at(row, "ay")).length(),
	]
	var normal := Vec2.new(_solver.normal_x, _solver.normal_y)
	return _table.normal_error(row, normal, _table.at(row, "r"), lengths)
