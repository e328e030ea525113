extends LabTest
## Tests of the question at one moment: does the ball overlap a line with ends?

var _line := LineSegment.new(Vec2.new(0.0, 0.0), Vec2.new(30.0, 40.0))


func test_a_ball_beside_the_middle_is_put_back_along_the_normal() -> void:
	# 5 px from the line on the side of its normal (-0.8, 0.6).
	var overlap := SegmentOverlap.with_segment(Vec2.new(15.0 - 4.0, 20.0 + 3.0), 10.0, _line)
	assert_eq([overlap.hit, overlap.feature], [true, Impact.Feature.LINE])
	assert_vec2(overlap.normal, Vec2.new(-0.8, 0.6), 1e-12)
	assert_vec2(overlap.position, Vec2.new(15.0 - 8.0, 20.0 + 6.0), 1e-12)


func test_a_ball_on_the_other_side_is_put_back_there() -> void:
	var overlap := SegmentOverlap.with_segment(Vec2.new(15.0 + 4.0, 20.0 - 3.0), 10.0, _line)
	assert_vec2(overlap.normal, Vec2.new(0.8, -0.6), 1e-12)


func test_beyond_an_end_the_nearest_point_is_that_end() -> void:
	var overlap := SegmentOverlap.with_segment(Vec2.new(30.0, 46.0), 10.0, _line)
	assert_eq(overlap.feature, Impact.Feature.END)
	assert_vec2(overlap.position, Vec2.new(30.0, 50.0), 1e-12)


func test_the_ends_themselves_belong_to_the_line() -> void:
	var level := LineSegment.new(Vec2.new(-100, 0), Vec2.new(100, 0))
	for x: float in [-100.0, 100.0]:
		var overlap := SegmentOverlap.with_segment(Vec2.new(x, 5), 10.0, level)
		assert_eq(overlap.feature, Impact.Feature.LINE)


func test_an_overlap_is_found_at_the_end_of_the_frame() -> void:
	assert_eq(SegmentOverlap.with_segment(Vec2.new(15, 20), 10.0, _line).fraction, 1.0)


func test_touching_is_not_overlapping() -> void:
	assert_false(SegmentOverlap.with_segment(Vec2.new(-10.0, 0.0), 10.0, _line).hit)


func test_a_centre_on_the_line_counts_as_on_the_side_of_the_normal() -> void:
	var overlap := SegmentOverlap.with_segment(Vec2.new(15.0, 20.0), 10.0, _line)
	assert_vec2(overlap.normal, Vec2.new(-0.8, 0.6), 1e-12)
