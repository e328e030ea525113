extends LabTest
## A ball is pushed out of what it overlaps: the shortest way, to the side of its centre.

const _SLACK := 1e-9


func test_out_of_one_line_the_shortest_way() -> void:
	for side: float in [1.0, -1.0]:
		var push := PushOut.new(Vec2.new(5, side * 3), 10.0, _SLACK)
		push.add_line(_line(-90, 0, 90, 0))
		assert_vec2(push.position(), Vec2.new(5, side * 10), 1e-12)


func test_what_touches_or_is_apart_stays_to_the_last_bit() -> void:
	for height: float in [10.0, 10.0 - 0.5 * _SLACK, 25.0]:
		var push := PushOut.new(Vec2.new(0.1, -height), 10.0, _SLACK)
		push.add_line(_line(-90, 0, 90, 0))
		assert_vec2(push.position(), Vec2.new(0.1, -height), 0.0)


func test_a_ball_that_belongs_on_the_other_side_goes_there() -> void:
	var push := PushOut.new(Vec2.new(5, 30), 10.0, _SLACK)
	push.add_line(_line(-90, 0, 90, 0), -1.0)
	assert_vec2(push.position(), Vec2.new(5, -10), 1e-12)


func test_in_a_corner_it_touches_both_lines() -> void:
	for degrees: float in [20.0, 60.0, 90.0, 140.0]:
		var up := Vec2.unit_degrees(-90.0 - 0.5 * degrees).scaled(500.0)
		var other := Vec2.new(-up.x, up.y)
		var push := PushOut.new(Vec2.new(0.1, -3), 10.0, _SLACK)
		push.add_line(LineSegment.new(Vec2.zero(), up))
		push.add_line(LineSegment.new(Vec2.zero(), other))
		var wanted := Vec2.new(0, -10.0 / sin(deg_to_rad(0.5 * degrees)))
		assert_vec2(push.position(), wanted, 1e-9, "%s degrees" % degrees)


func test_out_of_the_round_end() -> void:
	var push := PushOut.new(Vec2.new(93, 4), 10.0, _SLACK)
	push.add_line(_line(-90, 0, 90, 0))
	assert_vec2(push.position(), Vec2.new(96, 8), 1e-12)


func test_between_a_line_and_a_round_end() -> void:
	var push := PushOut.new(Vec2.new(5, -6), 10.0, _SLACK)
	var floor_line := _line(-90, 0, 90, 0)
	var post := _line(12, -12, 90, -12)
	push.add_line(floor_line)
	push.add_line(post)
	var at := push.position()
	assert_almost_eq(at.y, -10.0, 1e-8)
	assert_almost_eq(post.closest_point(at).distance_to(at), 10.0, 1e-8)


func test_walls_keep_it_inside() -> void:
	var push := PushOut.new(Vec2.new(-30, 95), 10.0, _SLACK)
	push.add_walls(Vec2.zero(), Vec2.new(100, 100))
	assert_vec2(push.position(), Vec2.new(10, 90), 1e-12)


func test_where_it_fits_nowhere_it_overlaps_least() -> void:
	var push := PushOut.new(Vec2.new(0, 1), 10.0, _SLACK)
	push.add_line(_line(-90, -6, 90, -6))
	push.add_line(_line(-90, 6, 90, 6))
	assert_between(push.position().y, -6.0, 6.0)


func test_random_lines_are_left_or_were_too_near_to_each_other() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 21
	var pushed := 0
	for trial: int in 2000:
		var at := Vec2.random_unit(rng).scaled(rng.randf_range(0, 30))
		var push := PushOut.new(at, 10.0, _SLACK)
		# Two lines that enclose at least 30 degrees.
		var lines: Array[LineSegment] = []
		for turn: float in [0.0, rng.randf_range(0.6, PI - 0.6)]:
			var along := Vec2.unit_radians(turn + 0.01 * trial).scaled(400.0)
			var middle := Vec2.random_unit(rng).scaled(rng.randf_range(0, 20))
			lines.append(LineSegment.new(middle.minus(along), middle.plus(along)))
			push.add_line(lines[-1])
		var sides := [PushOut.side_of(lines[0], at), PushOut.side_of(lines[1], at)]
		var end := push.position()
		pushed += int(end.distance_to(at) > 0.0)
		for place: int in 2:
			var gap := lines[place].closest_point(end).distance_to(end) - 10.0
			if gap < -2.0 * _SLACK or PushOut.side_of(lines[place], end) != sides[place]:
				fail_test("trial %d: gap %s" % [trial, gap])
	assert_gt(pushed, 500)


func test_a_moved_line_keeps_its_sides() -> void:
	var old := _line(0, 0, 90, 0)
	assert_eq(PushOut.side_after(1.0, old, _line(0, 5, 90, 9)), 1.0)
	assert_eq(PushOut.side_after(1.0, old, _line(90, 9, 0, 5)), -1.0)
	assert_eq(PushOut.side_touched(old, Vec2.new(5, 10), 10.0), 1.0)
	assert_eq(PushOut.side_touched(old, Vec2.new(5, -10), 10.0), -1.0)
	assert_eq(PushOut.side_touched(old, Vec2.new(5, -11), 10.0), 0.0)
	assert_eq(PushOut.side_touched(old, Vec2.new(-1, -5), 10.0), 0.0)


func _line(from_x: float, from_y: float, to_x: float, to_y: float) -> LineSegment:
	return LineSegment.new(Vec2.new(from_x, from_y), Vec2.new(to_x, to_y))
