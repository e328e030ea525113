extends LabTest
## The exact impact under constant acceleration with a segment, against 1500 answers that were
## computed with 60 digits, and against answers that can be written down.

const _TIME_BOUND := 4.0
const _NORMAL_BOUND := 4.0

var _table := ImpactTable.new("ball_segment_gravity")
var _straight := ImpactTable.new("ball_segment")
var _solver := AcceleratedImpactFinder.new()


func test_hit_or_miss_agrees_in_every_row() -> void:
	var wrong := PackedInt32Array()
	for row: int in _table.size():
		if _solve(row) != _table.is_hit(row):
			wrong.append(row)
	assert_eq(wrong, PackedInt32Array())


func test_a_ball_that_touches_and_moves_along_has_no_impact() -> void:
	assert_false(_solve_numbers([3, 10, 7, 0, 0, 0, 10], [0, 0, 20, 0]))
	assert_false(_solve_numbers([3, 10, 7, 0, 0, -50, 10], [0, 0, 20, 0]))


func test_the_time_is_right_to_the_last_bits() -> void:
	var worst := WorstErrors.new()
	for row: int in _table.size():
		if _solve(row) and _table.is_hit(row):
			worst.note(_table.family(row), _table.time_error(row, _solver.time))
	gut.p("worst error of the time, under gravity: %s" % worst)
	assert_all_at_most(worst.values(), _TIME_BOUND)


func test_the_normal_is_right_to_the_last_bits() -> void:
	var worst := WorstErrors.new()
	for row: int in _table.size():
		if _solve(row) and _table.is_hit(row):
			worst.note(_table.family(row), _normal_error(row))
	gut.p("worst error of the normal, under gravity: %s" % worst)
	assert_all_at_most(worst.values(), _NORMAL_BOUND)


func test_the_feature_is_the_one_that_is_touched() -> void:
	var wrong := PackedInt32Array()
	for row: int in _table.size():
		# Features 1, 2, 3 in the file are line, start, end. At a boundary both are right.
		if _table.family(row) == "random" and _solve(row) and _table.is_hit(row):
			if _solver.feature != int(_table.at(row, "feature")) - 1:
				wrong.append(row)
	assert_eq(wrong, PackedInt32Array())


func test_the_segment_turned_round_gives_the_same_impact() -> void:
	var differences := PackedFloat64Array()
	for row: int in _table.size():
		var is_hit := _solve(row)
		var time := _solver.time
		var ends := _numbers(_table, row, ["bx", "by", "ax", "ay"])
		if _solver.with_segment(ends[0], ends[1], ends[2], ends[3], INF) != is_hit:
			differences.append(INF)
		elif is_hit and _solver.time != time:
			var bound := EPSILON * maxf(_table.at(row, "condition"), time)
			differences.append(absf(_solver.time - time) / bound)
	assert_all_at_most(differences, _TIME_BOUND)


func test_a_horizon_hides_what_comes_later_and_changes_nothing_before() -> void:
	var wrong := PackedInt32Array()
	for row: int in _table.size():
		var ends := _numbers(_table, row, ["ax", "ay", "bx", "by"])
		if _solve(row) and _solver.time > 0.0:
			var time := _solver.time
			if _solver.with_segment(ends[0], ends[1], ends[2], ends[3], 0.999999 * time):
				wrong.append(row)
			var is_hit := _solver.with_segment(ends[0], ends[1], ends[2], ends[3], 1.000001 * time)
			if not is_hit or _solver.time != time:
				wrong.append(row)
	assert_eq(wrong, PackedInt32Array())


func test_without_acceleration_it_flies_straight() -> void:
	var worst := WorstErrors.new()
	for row: int in _straight.size():
		var flight := _numbers(_straight, row, ["px", "py", "vx", "vy", "r"])
		flight = [flight[0], flight[1], flight[2], flight[3], 0.0, 0.0, flight[4]]
		var is_hit := _solve_numbers(flight, _numbers(_straight, row, ["ax", "ay", "bx", "by"]))
		if is_hit != _straight.is_hit(row):
			worst.note("hit or miss", INF)
		elif is_hit:
			worst.note(_straight.family(row), _straight.time_error(row, _solver.time))
	gut.p("worst error of the time, acceleration 0: %s" % worst)
	assert_all_at_most(worst.values(), _TIME_BOUND)


func test_a_ball_at_rest_falls_as_galilei_says_or_stays() -> void:
	assert_true(_solve_numbers([5, -42, 0, 0, 0, 4, 10], [0, 0, 20, 0]))
	assert_eq([_solver.time, _solver.normal_x, _solver.normal_y], [4.0, 0.0, -1.0])
	assert_false(_solve_numbers([5, -42, 0, 0, 0, 0, 10], [0, 0, 20, 0]))


func test_a_ball_thrown_from_the_line_comes_back_to_it() -> void:
	assert_true(_solve_numbers([0, -10, 3, -6, 0, 4, 10], [-50, 0, 50, 0]))
	assert_eq([_solver.time, _solver.normal_y], [3.0, -1.0])


func test_an_apex_that_only_grazes_the_line_is_no_impact() -> void:
	# The ball rises by 8² / (2 * 2) = 16, to exactly one radius below the line.
	var thrown: PackedFloat64Array = [5, 19, 0, -8, 0, 2, 3]
	assert_false(_solve_numbers(thrown, [0, 0, 20, 0]))
	thrown[6] = 3.0 + 2.0 * EPSILON
	assert_true(_solve_numbers(thrown, [0, 0, 20, 0]))
	# Now the apex is inside by h = 2 EPSILON, and g t² / 2 = h gives how much earlier it touches.
	assert_almost_eq(_solver.time, 4.0 - sqrt(2.0 * EPSILON), 1e-15)


func test_a_path_that_only_grazes_a_cap_is_no_impact() -> void:
	# After 1 s the ball is at (0, -3) with the velocity (8, 0). Its path curves less than the cap.
	var thrown: PackedFloat64Array = [-8, -2, 8, -2, 0, 2, 3]
	assert_false(_solve_numbers(thrown, [0, 0, -1, 50]))
	thrown[6] = 3.0 + 2.0 * EPSILON
	assert_true(_solve_numbers(thrown, [0, 0, -1, 50]))
	# At s seconds from then, |d|² - r² is about (8² - 2 * 3) s² - 2 * 3 * 2 EPSILON.
	assert_almost_eq(_solver.time, 1.0 - sqrt(12.0 * EPSILON / 58.0), 1e-15)


func test_a_centre_inside_the_line_that_leaves_falls_back_on_it() -> void:
	# It rises from 4 to 20 above the line, and falls back to 10, its radius.
	assert_true(_solve_numbers([0, -4, 0, -8, 0, 2, 10], [-50, 0, 50, 0]))
	assert_almost_eq(_solver.time, 4.0 + sqrt(10.0), 1e-15)


func test_a_centre_inside_a_cap_that_leaves_falls_back_on_it() -> void:
	assert_true(_solve_numbers([0, -4, 0, -8, 0, 2, 10], [0, 0, 0, 50]))
	assert_almost_eq(_solver.time, 4.0 + sqrt(10.0), 1e-15)
	assert_eq([_solver.feature, _solver.normal_y], [Impact.Feature.START, -1.0])


func test_a_centre_inside_that_turns_round_inside_does_not_impact() -> void:
	# It rises from 4 to only 8 above the line. So it always overlaps, and falls through.
	assert_false(_solve_numbers([0, -4, 0, -4, 0, 2, 10], [-50, 0, 50, 0]))


func test_a_ball_thrown_through_the_strip_beside_the_line_falls_on_it_from_above() -> void:
	# It rises past the end in 1 s, is above the line after 2 s and lands on it after 4.
	assert_true(_solve_numbers([-60, 35, 20, -40, 0, 15, 5], [-10, 0, 90, 0]))
	assert_eq([_solver.time, _solver.feature], [4.0, Impact.Feature.LINE])


func test_no_ball_slips_between_line_and_cap() -> void:
	var missed := PackedFloat64Array()
	var late := PackedFloat64Array()
	for exponent: int in range(-60, 0):
		for beyond: float in [2.0 ** exponent, -(2.0 ** exponent), 0.0]:
			# A line turned by 30 degrees about its end, met by a ball exactly above that end.
			var along := Vec2.unit_degrees(30.0)
			var contact := along.scaled(-beyond).plus(Vec2.new(along.y, -along.x).scaled(7.0))
			var flight: PackedFloat64Array = [contact.x + 10, contact.y - 2, -30, -8, 40, 20, 7]
			if not _solve_numbers(flight, [0, 0, 100.0 * along.x, 100.0 * along.y]):
				missed.append(beyond)
			elif beyond <= 0.0:
				late.append(absf(_solver.time - 1.0))
	assert_eq(missed, PackedFloat64Array())
	assert_all_at_most(late, 1e-14)


func _solve(row: int) -> bool:
	var flight := _numbers(_table, row, ["px", "py", "vx", "vy", "gx", "gy", "r"])
	return _solve_numbers(flight, _numbers(_table, row, ["ax", "ay", "bx", "by"]))


func _solve_numbers(flight: PackedFloat64Array, ends: PackedFloat64Array) -> bool:
	_solver.set_flight(flight[0], flight[1], flight[2], flight[3], flight[4], flight[5], flight[6])
	return _solver.with_segment(ends[0], ends[1], ends[2], ends[3], INF)


func _normal_error(row: int) -> float:
	var n := _numbers(_table, row, ["vx", "vy", "px", "py", "ax", "ay"])
	var lengths: PackedFloat64Array = [
		Vec2.new(n[0], n[1]).length(), Vec2.new(n[2], n[3]).length(), Vec2.new(n[4], n[5]).length()
	]
	var normal := Vec2.new(_solver.normal_x, _solver.normal_y)
	return _table.normal_error(row, normal, _table.at(row, "r"), lengths)


func _numbers(table: ImpactTable, row: int, columns: PackedStringArray) -> PackedFloat64Array:
	var numbers := PackedFloat64Array()
	for column: String in columns:
		numbers.append(table.at(row, column))
	return numbers
