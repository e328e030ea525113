extends LabTest
## Where a dropped ball is exactly, compared with hops that are worked out one by one.


func test_it_falls_freely_at_first() -> void:
	# g t^2 / 2 = 31.25 px after a quarter of a second.
	assert_almost_eq(DroppedBall.height_after(0.25, 0.8), 168.75, 1e-12)


func test_it_comes_back_to_its_height_when_it_keeps_its_energy() -> void:
	var round_trip := 2.0 * sqrt(2.0 * DroppedBall.HEIGHT / DroppedBall.GRAVITY)
	assert_almost_eq(DroppedBall.height_after(round_trip, 1.0), DroppedBall.HEIGHT, 1e-9)
	assert_almost_eq(DroppedBall.height_after(40.0 * round_trip, 1.0), DroppedBall.HEIGHT, 1e-9)


func test_the_top_of_the_first_hop_has_the_share_c_squared() -> void:
	var fall := sqrt(2.0 * DroppedBall.HEIGHT / DroppedBall.GRAVITY)
	for bounciness: float in [0.8, 0.5]:
		var top := DroppedBall.height_after(fall * (1.0 + bounciness), bounciness)
		assert_almost_eq(top, bounciness ** 2 * DroppedBall.HEIGHT, 1e-9)


func test_the_top_of_the_third_hop_too() -> void:
	var fall := sqrt(2.0 * DroppedBall.HEIGHT / DroppedBall.GRAVITY)
	var time := fall * (1.0 + 2.0 * 0.5 + 2.0 * 0.25 + 0.125)
	assert_almost_eq(DroppedBall.height_after(time, 0.5), 0.5 ** 6 * DroppedBall.HEIGHT, 1e-9)


func test_it_lies_still_after_the_sum_of_all_hops() -> void:
	# The hops end after 1 + 2 C + 2 C^2 + ... = (1 + C) / (1 - C) times the first fall: 9 for
	# C = 0.8, 3 for 0.5, 1 for 0.
	var fall := sqrt(2.0 * DroppedBall.HEIGHT / DroppedBall.GRAVITY)
	assert_almost_eq(DroppedBall.rest_time(0.8) / fall, 9.0, 1e-12)
	assert_almost_eq(DroppedBall.rest_time(0.5) / fall, 3.0, 1e-12)
	assert_eq(DroppedBall.height_after(3.01 * fall, 0.5), 0.0)
	assert_gt(DroppedBall.height_after(2.99 * fall, 0.5), 0.0)


func test_with_no_bounciness_it_stays_where_it_falls() -> void:
	var fall := sqrt(2.0 * DroppedBall.HEIGHT / DroppedBall.GRAVITY)
	assert_almost_eq(DroppedBall.rest_time(0.0), fall, 1e-15)
	assert_eq(DroppedBall.height_after(fall * 1.0001, 0.0), 0.0)


func test_the_energy_at_the_start_is_one() -> void:
	assert_eq(DroppedBall.energy_share(DroppedBall.HEIGHT, 0.0), 1.0)
	var speed := sqrt(2.0 * DroppedBall.GRAVITY * DroppedBall.HEIGHT)
	assert_almost_eq(DroppedBall.energy_share(0.0, speed), 1.0, 1e-15)
