extends LabTest
## Shots that fly, and by how much they miss.


func test_a_bullet_falls_as_the_formula_says() -> void:
	var shot := FiredShot.new(Vec2.zero(), Vec2.new(200, -150), Vec2.new(0, 300))
	assert_almost_eq(shot.place_after(1.0).distance_to(Vec2.new(200, 0)), 0.0, 1e-12)
	# Back in time, too.
	assert_almost_eq(shot.place_after(0.5).distance_to(Vec2.new(100, -37.5)), 0.0, 1e-12)


func test_a_bullet_bounces_with_its_radius() -> void:
	var floor_line: Array[LineSegment] = [LineSegment.new(Vec2.new(0, 300), Vec2.new(400, 300))]
	var velocity := Vec2.new(120, 180)
	var shot := FiredShot.new(Vec2.new(100, 100), velocity, Vec2.zero(), 20.0, floor_line)
	assert_almost_eq(shot.place_after(1.0).distance_to(Vec2.new(220, 280)), 0.0, 1e-12)
	assert_almost_eq(shot.place_after(2.0).distance_to(Vec2.new(340, 100)), 0.0, 1e-12)


func test_the_corners_of_a_shot_are_its_start_its_bounces_and_its_end() -> void:
	var floor_line: Array[LineSegment] = [LineSegment.new(Vec2.new(0, 300), Vec2.new(400, 300))]
	var velocity := Vec2.new(120, 180)
	var shot := FiredShot.new(Vec2.new(100, 100), velocity, Vec2.zero(), 20.0, floor_line)
	var corners := shot.corners(2.0)
	var wanted: Array[Vec2] = [Vec2.new(100, 100), Vec2.new(220, 280), Vec2.new(340, 100)]
	assert_eq(corners.size(), wanted.size())
	for place: int in wanted.size():
		assert_almost_eq(corners[place].distance_to(wanted[place]), 0.0, 1e-12)
	assert_eq(shot.corners(0.5).size(), 2, "not before it bounces")


func test_a_shot_at_where_the_target_is_now_misses_by_123() -> void:
	var target := AimTarget.new(Vec2.new(240, 0), Vec2.new(0, 90))
	var shot := FiredShot.new(Vec2.zero(), Vec2.new(150, 0))
	var moment := ShotSearch.nearest_moment(shot, target.position_after, 5.0)
	var miss := shot.distance_after(moment, target.position_after)
	# The target passes at (240, 0) + (−150, 90) t: the distance of that line from the origin.
	assert_almost_eq(miss, 240.0 * 90.0 / sqrt(150.0 * 150.0 + 90.0 * 90.0), 1e-9)


func test_a_right_shot_is_nearest_when_it_hits() -> void:
	var target := AimTarget.new(Vec2.new(240, 0), Vec2.new(0, 90))
	var shot := FiredShot.new(Vec2.zero(), Vec2.new(120, 90))
	var moment := ShotSearch.nearest_moment(shot, target.position_after, 5.0)
	assert_almost_eq(moment, 2.0, 1e-12)
	assert_almost_eq(shot.distance_after(moment, target.position_after), 0.0, 1e-10)


func test_what_cannot_be_flown_is_told() -> void:
	var shot := FiredShot.new(Vec2.zero(), Vec2.new(NAN, 0))
	assert_push_error("nan")
	assert_eq(shot.place_after(1.0).length(), 0.0)


func test_the_condition_counts_every_number_by_its_size() -> void:
	# The miss is 3 x − y t: each number by itself counts by its share.
	var miss := func(numbers: PackedFloat64Array) -> Vec2:
		return Vec2.new(3.0 * numbers[0] - numbers[1] * numbers[2], 0.0)
	assert_almost_eq(ShotCondition.of([2.0, 6.0, 1.0], miss), 6.0 + 6.0 + 6.0, 1e-9)


func test_a_shot_at_a_far_target_is_the_more_sensitive() -> void:
	var near := ShotCondition.of([100.0, 1.0, 50.0, 2.0], _miss_along_x)
	var far := ShotCondition.of([1e6, 1.0, 50.0, 2e4], _miss_along_x)
	assert_almost_eq(far / near, 1e4, 1e-4)


# How far a bullet is from a target on the x axis: place, direction, speed and time.
static func _miss_along_x(numbers: PackedFloat64Array) -> Vec2:
	return Vec2.new(numbers[0] - numbers[1] * numbers[2] * numbers[3], 0.0)
