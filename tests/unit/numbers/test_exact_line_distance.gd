extends LabTest
## The exact distance from a line and the exact contact on a path. Readouts compare with them.

## The square root of one half with 106 bits: the nearest double, and the rest.
const ROOT_OF_HALF_HIGH := 0.7071067811865476
const ROOT_OF_HALF_LOW := -4.833646656726457e-17


func test_the_distance_from_a_diagonal_is_the_root_of_one_half() -> void:
	var line := LineSegment.new(Vec2.new(0, 0), Vec2.new(1, 1))
	var distance := ExactLineDistance.signed_distance(Vec2.new(0, 1), line)
	assert_almost_eq(distance.error_of(ROOT_OF_HALF_HIGH), -ROOT_OF_HALF_LOW, 1e-30)


func test_the_good_side_is_positive() -> void:
	var line := LineSegment.new(Vec2.new(5, 0), Vec2.new(0, 0))
	assert_eq(ExactLineDistance.signed_distance(Vec2.new(2, -3), line).to_float(), 3.0)
	assert_eq(ExactLineDistance.error_of(3.5, Vec2.new(2, -3), line), 0.5)


func test_coordinates_that_share_no_digit_lose_nothing() -> void:
	var line := LineSegment.new(Vec2.new(1e16, 0), Vec2.new(-1e16, 0))
	assert_eq(ExactLineDistance.signed_distance(Vec2.new(3e15, -1e-16), line).to_float(), 1e-16)


func test_the_contact_of_the_lecture_is_in_the_middle_of_the_frame() -> void:
	var line := LineSegment.new(Vec2.new(60, 45), Vec2.new(-60, -45))
	var share := ExactContact.fraction(Vec2.new(6, -58), Vec2.new(6, 42), 10.0, line)
	assert_almost_eq(share.error_of(0.5), 0.0, 1e-30)


func test_a_place_beside_the_contact_is_off_by_its_distance() -> void:
	var line := LineSegment.new(Vec2.new(60, 45), Vec2.new(-60, -45))
	var old := Vec2.new(6, -58)
	var new := Vec2.new(6, 42)
	assert_almost_eq(
		ExactContact.distance_from(Vec2.new(30, 10), old, new, 10.0, line), 30.0, 1e-14
	)
	assert_almost_eq(ExactContact.distance_from(Vec2.new(6, -8), old, new, 10.0, line), 0.0, 1e-28)
