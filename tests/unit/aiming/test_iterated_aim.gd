extends LabTest
## Aims by guessing the time of flight again and again: how far they miss.


func test_no_round_aims_at_the_present_place_and_one_round_misses_by_less() -> void:
	var target := AimTarget.new(Vec2.new(240, 0), Vec2.new(0, 90))
	var misses: PackedFloat64Array = []
	for rounds: int in 3:
		var aim := IteratedAim.lead(Vec2.zero(), target, 150, rounds)
		var shot := FiredShot.new(Vec2.zero(), aim.direction.scaled(150))
		var moment := ShotSearch.nearest_moment(shot, target.position_after, 5.0)
		misses.append(shot.distance_after(moment, target.position_after))
	assert_almost_eq(misses[0], 123.48, 0.01)
	assert_almost_eq(misses[1], 23.81, 0.01)
	assert_almost_eq(misses[2], 7.82, 0.01)


func test_one_round_guesses_the_time_to_the_present_place() -> void:
	var target := AimTarget.new(Vec2.new(240, 0), Vec2.new(0, 90))
	var aim := IteratedAim.lead(Vec2.zero(), target, 150, 1)
	assert_almost_eq(aim.time, 1.6, 1e-15)
	assert_vec2(aim.target, Vec2.new(240, 144), 1e-12)


func test_many_rounds_come_to_the_answer_where_the_target_is_slower() -> void:
	var slow := AimTarget.new(Vec2.new(240, 0), Vec2.new(0, 90), Vec2.zero(), 6.0)
	var aim := IteratedAim.lead(Vec2.zero(), slow, 150, 60)
	assert_vec2(aim.direction, LeadAim.first(Vec2.zero(), slow, 150).direction, 1e-14)
	assert_almost_eq(aim.time, LeadAim.first(Vec2.zero(), slow, 150).time, 1e-14)


func test_many_rounds_go_astray_where_the_target_is_faster() -> void:
	# It comes nearer, so that it can be hit.
	var fast := AimTarget.new(Vec2.new(240, 0), Vec2.new(-180, 40))
	var wanted := LeadAim.first(Vec2.zero(), fast, 150)
	assert_true(wanted.hit)
	var aim := IteratedAim.lead(Vec2.zero(), fast, 150, 60)
	assert_gt(absf(aim.time - wanted.time), 0.1)


func test_under_gravity_rounds_come_to_the_flat_arc() -> void:
	var gravity := Vec2.new(0, 300)
	var target := AimTarget.new(Vec2.new(150, -20), Vec2.new(30, 10))
	var wanted := BallisticAim.at_moving(Vec2.zero(), target, gravity, 400, 10)[0]
	var errors: PackedFloat64Array = []
	for rounds: int in [1, 4, 60]:
		var aim := IteratedAim.ballistic(Vec2.zero(), target, gravity, 400, rounds)
		errors.append(aim.direction.distance_to(wanted.direction))
	assert_gt(errors[0], 1e-3)
	assert_lt(errors[1], errors[0] / 100)
	assert_lt(errors[2], 1e-14)


func test_what_cannot_be_reached_now_has_no_shot() -> void:
	var coming := AimTarget.new(Vec2.new(300, 0), Vec2.new(-200, 0))
	var gravity := Vec2.new(0, 300)
	assert_gt(BallisticAim.at_moving(Vec2.zero(), coming, gravity, 250, 10).size(), 0)
	assert_false(IteratedAim.ballistic(Vec2.zero(), coming, gravity, 250, 5).hit)


func test_a_speed_that_is_none_is_an_error() -> void:
	assert_false(IteratedAim.lead(Vec2.zero(), AimTarget.new(Vec2.new(1, 0)), 0, 1).hit)
	assert_push_error("must be above 0 px/s")
