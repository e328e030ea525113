extends LabTest
## Many balls: how they begin, and how overlap, distance and energy are found.


func test_a_tenth_of_the_box_is_covered() -> void:
	var crowd := Crowd.new(100, 1.0)
	assert_almost_eq(100.0 * PI * 100.0 / crowd.side ** 2, 0.1, 1e-12)


func test_no_balls_overlap_at_the_start_and_all_are_inside() -> void:
	for count: int in [2, 10, 100, 1000]:
		var crowd := Crowd.new(count, 1.0)
		var places: PackedFloat64Array = []
		for ball in crowd.balls():
			places.append_array([ball.position.x, ball.position.y])
		assert_eq(Crowd.worst_overlap(places), 0.0)
		var sorted := places.duplicate()
		sorted.sort()
		assert_gte(sorted[0], Crowd.RADIUS)
		assert_lte(sorted[-1], crowd.side - Crowd.RADIUS)


func test_speeds_are_within_their_bounds() -> void:
	for ball in Crowd.new(100, 1.0).balls():
		assert_between(ball.velocity.length(), Crowd.SLOWEST - 1e-9, Crowd.FASTEST + 1e-9)


func test_the_balls_are_the_same_every_time() -> void:
	assert_vec2(Crowd.new(10, 1.0).balls()[7].position, Crowd.new(10, 2.0).balls()[7].position, 0.0)


func test_the_overlap_is_two_radii_less_the_distance() -> void:
	# 3-4-5 triangle: 15 px apart, radii of 10 px.
	assert_almost_eq(Crowd.worst_overlap([0.0, 0.0, 100.0, 0.0, 109.0, 12.0]), 5.0, 1e-12)


func test_the_overlap_agrees_with_looking_at_every_pair() -> void:
	var places: PackedFloat64Array = []
	for vector in random_vectors(3, 60, 80.0):
		places.append_array([vector.x, vector.y])
	var worst := 0.0
	for one in range(0, places.size(), 2):
		for other in range(0, one, 2):
			var across := places[one] - places[other]
			var down := places[one + 1] - places[other + 1]
			worst = maxf(worst, 20.0 - Vec2.new(across, down).length())
	assert_almost_eq(Crowd.worst_overlap(places), worst, 1e-12)


func test_the_worst_distance_is_that_of_one_ball() -> void:
	assert_eq(Crowd.worst_distance([0.0, 0.0, 5.0, 5.0], [0.0, 1.0, 8.0, 9.0]), 5.0)


func test_the_drift_is_a_share_of_the_energy() -> void:
	assert_almost_eq(Crowd.energy_drift([3.0, 4.0, 0.0, 0.0], [3.0, 0.0, 0.0, 0.0]), 0.64, 1e-15)


func test_the_event_world_keeps_energy_and_distance_and_finds_back() -> void:
	var case := EventCrowd.new(Crowd.new(2, 3.0), 60)
	case.run_once()
	assert_lt(case.error, 1e-9)
	assert_lt(case.figures["energy drift"], 1e-12)
	assert_eq(case.figures["reversed"], 3.0)
	assert_string_contains(case.note, "collisions a second")


func test_a_run_that_does_not_find_back_says_when() -> void:
	var case := Drifting.new(Crowd.new(2, 1.0), 60)
	case.run_once()
	# It drifts 0.3 px a frame: after 4 frames it is more than 1 px off.
	assert_almost_eq(case.figures["reversed"], 4.0 / 60.0, 1e-12)
	assert_string_contains(case.note, "1 px off its own way after 0.07 s of 1.0 s")


func test_every_size_is_measured() -> void:
	var situations: Dictionary[String, bool] = {}
	for case in ManyBallsProblem.new().cases(true):
		situations[case.situation] = true
	assert_eq(situations.keys(), ["2 balls", "10 balls", "100 balls", "1000 balls"])


# Balls at rest at 0, of which the first coordinate drifts by this much a frame.
class Drifting:
	extends CrowdFlight

	var drift := 0.0

	func _prepare() -> void:
		_places.fill(0.0)

	func _fly(count: int) -> void:
		_places[0] += count * drift
		_spent = 1e6

	func _velocities() -> PackedFloat64Array:
		return [1.0, 0.0, 1.0, 0.0]

	func _turn_round() -> void:
		drift = 0.3
