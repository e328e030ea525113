extends LabTest
## A ball between two walls of which one comes nearer.


# The lesson on platforms: the way left is 200 / (n + 1), the speed 300 + 200 n.
func test_the_lesson_s_bounces() -> void:
	for bounce: int in 10:
		assert_eq(Press.speed_after(bounce, 300, 100), 300.0 + 200.0 * bounce)
		assert_almost_eq(Press.way_after(bounce, 200, 300, 100), 200.0 / (bounce + 1), 1e-13)


func test_the_lesson_s_press_over_time() -> void:
	var press := Press.at(0.0, 200, 300, 100)
	assert_eq([press.bounces, press.way, press.speed, press.distance], [0.0, 200.0, 300.0, 200.0])
	press = Press.at(0.5, 200, 300, 100)
	assert_eq([press.bounces, press.way, press.speed, press.distance], [0.0, 150.0, 300.0, 50.0])
	press = Press.at(1.0, 200, 300, 100)
	assert_eq([press.bounces, press.way, press.speed, press.distance], [1.0, 100.0, 500.0, 100.0])
	press = Press.at(1.75, 200, 300, 100)
	assert_eq([press.bounces, press.way, press.speed], [7.0, 25.0, 1700.0])


func test_it_is_crushed_when_the_walls_meet_and_there_is_no_answer_beyond() -> void:
	for seconds: float in [2.0, 2.5, 1e300]:
		var press := Press.at(seconds, 200, 300, 100)
		assert_true(press.is_crushed)
		assert_eq(press.time, 2.0)
	assert_false(Press.at(2.0 - 1e-15, 200, 300, 100).is_crushed)


func test_shortly_before_the_bounces_cannot_be_counted_one_by_one() -> void:
	var press := Press.at(2.0 - 1e-12, 200, 300, 100)
	assert_gt(press.bounces, 1e12)
	assert_between(press.distance, 0.0, press.way * (1.0 + 1e-9))


# Each flight to the other wall and back is followed by the laws of motion.
func test_it_agrees_with_following_the_bounces_one_by_one() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 41
	for number: int in 100:
		var way := rng.randf_range(10, 400)
		var wall := rng.randf_range(5, 100)
		var ball := wall + rng.randf_range(10, 400)
		var seconds := way / wall * rng.randf_range(0.0, 0.99)
		var press := Press.at(seconds, way, ball, wall)
		var followed := _followed(seconds, way, ball, wall)
		assert_eq(press.bounces, followed[0])
		assert_almost_eq(press.speed, followed[1], 1e-9)
		assert_almost_eq(press.distance, followed[2], 1e-6)


# The bounces off the moving wall, the speed, and the distance from the wall at rest.
static func _followed(seconds: float, way: float, ball: float, wall: float) -> PackedFloat64Array:
	var bounces := 0.0
	var time := 0.0
	while time + 2.0 * way / (ball + wall) <= seconds:
		time += 2.0 * way / (ball + wall)
		way *= (ball - wall) / (ball + wall)
		ball += 2.0 * wall
		bounces += 1.0
	return [bounces, ball, absf(way - ball * (seconds - time))]


func test_what_cannot_be_used_is_an_error() -> void:
	for bad: float in [-1.0, INF, NAN]:
		Press.at(bad, 200, 300, 100)
		assert_push_error("The time must be 0 s or more and finite, not %s s." % bad)
	Press.at(1, 0, 300, 100)
	assert_push_error("The free way must be within 1e-70..1e+70 px, not 0.0.")
	Press.at(1, 200, 300, 0)
	assert_push_error("The wall must come nearer with 1e-70..1e+70 px/s, not 0.0.")
	for bad: float in [100.0, INF, NAN]:
		var press := Press.at(1, 200, bad, 100)
		var wanted := "The ball must be faster than the wall's 100.0 px/s, at most 1e+70, not %s."
		assert_push_error(wanted % bad)
		assert_false(press.is_crushed)
