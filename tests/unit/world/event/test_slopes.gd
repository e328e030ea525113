extends LabTest
## The lines of a world on which balls roll.


func test_a_segment_is_a_line_with_the_gravity_and_friction_of_the_world() -> void:
	var slopes := _slopes()
	var line := slopes.at(0)
	assert_eq([line.pull, line.pressure, line.length], [360.0, 480.0, 5.0])
	assert_true(line.can_hold())
	assert_same(slopes.at(0), line)


func test_each_wall_is_a_line() -> void:
	var slopes := _slopes()
	assert_eq(
		[slopes.at(Slopes.BOTTOM_WALL).pressure, slopes.at(Slopes.BOTTOM_WALL).pull], [600.0, 0.0]
	)
	assert_eq(
		[slopes.at(Slopes.TOP_WALL).length, slopes.at(Slopes.LEFT_WALL).length], [300.0, 200.0]
	)
	assert_eq(
		[slopes.at(Slopes.RIGHT_WALL).pull, slopes.at(Slopes.RIGHT_WALL).length], [600.0, 200.0]
	)


func test_after_a_change_the_lines_are_made_anew() -> void:
	var slopes := _slopes()
	var line := slopes.at(0)
	slopes.set_up(_scan(), Vec2.zero(), Vec2.new(300, 200), Vec2.new(0, 600), 0.1)
	assert_not_same(slopes.at(0), line)
	assert_false(slopes.at(0).can_hold())


func _slopes() -> Slopes:
	var slopes := Slopes.new()
	slopes.set_up(_scan(), Vec2.zero(), Vec2.new(300, 200), Vec2.new(0, 600), 0.3)
	return slopes


func _scan() -> SegmentScan:
	var scan := SegmentScan.new()
	scan.put(0, LineSegment.new(Vec2.zero(), Vec2.new(4, 3)))
	return scan
