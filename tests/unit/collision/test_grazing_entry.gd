extends LabTest
## The entry into a circle that a path nearly grazes: the last bit of a number decides.


func test_the_depth_below_the_circle_decides() -> void:
	# After 1 s the ball is at (0, -3) with the velocity (8, 0). At s seconds from then, |d|² - 3²
	# is about 58 s².
	assert_eq(GrazingEntry.time(-8, -2, 8, -2, 0, 2, 3.0, 0, 0, 1.0), INF)
	assert_eq(GrazingEntry.time(-8, -2, 8, -2, 0, 2, 3.0 - 2.0 * EPSILON, 0, 0, 1.0), INF)
	var entry := GrazingEntry.time(-8, -2, 8, -2, 0, 2, 3.0 + 2.0 * EPSILON, 0, 0, 1.0)
	assert_almost_eq(entry, 1.0 - sqrt(12.0 * EPSILON / 58.0), 1e-16)


func test_a_moment_near_the_lowest_point_is_enough() -> void:
	var radius := 3.0 + 2.0 * EPSILON
	var exact := GrazingEntry.time(-8, -2, 8, -2, 0, 2, radius, 0, 0, 1.0)
	var near := GrazingEntry.time(-8, -2, 8, -2, 0, 2, radius, 0, 0, 1.0 - 1e-4)
	assert_almost_eq(near, exact, EPSILON)


func test_a_path_that_hardly_leaves_comes_back_after_its_highest_point() -> void:
	# After 1 s the path touches the top of a circle of radius 8, and curves more than the circle.
	# At s seconds from then, |d|² - 8² is about (2² - 8 * 2) s². The path leaves a slightly smaller
	# circle for a moment, and comes back.
	assert_eq(GrazingEntry.time(-2, -7, 2, -2, 0, 2, 8.0, 0, 0, 1.0), INF)
	var entry := GrazingEntry.time(-2, -7, 2, -2, 0, 2, 8.0 - 4.0 * EPSILON, 0, 0, 1.0)
	assert_almost_eq(entry, 1.0 + sqrt(64.0 * EPSILON / 12.0), 1e-15)


func test_it_agrees_with_the_root_in_straight_flight() -> void:
	# At 2 s the ball is 1e-6 px inside: 20² s² = 2 * 5 * 1e-6 at s seconds from then.
	var entry := GrazingEntry.time(-40, 5 - 1e-6, 20, 0, 0, 0, 5, 0, 0, 2.0)
	assert_almost_eq(entry, 2.0 - sqrt((10.0 - 1e-6) * 1e-6) / 20.0, 1e-13)
