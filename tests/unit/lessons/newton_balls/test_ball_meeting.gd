extends LabTest
## Two balls that meet: the worked numbers of the course, and what Newton's laws keep.


func test_the_worked_numbers_of_the_course() -> void:
	var wanted := {1.0: [-2.0, 4.0], 0.5: [0.0, 3.0], 0.0: [2.0, 2.0]}
	for bounciness: float in wanted:
		var after := _one_to_two(bounciness).velocities_after()
		var numbers: PackedFloat64Array = wanted[bounciness]
		assert_vec2(after[0], Vec2.new(numbers[0], 0.0), 1e-15)
		assert_vec2(after[1], Vec2.new(numbers[1], 0.0), 1e-15)


func test_center_closing_speed_and_impulse() -> void:
	var meeting := _one_to_two(1.0)
	assert_vec2(meeting.center_velocity(), Vec2.new(2.0, 0.0), 1e-15)
	assert_eq(meeting.closing_speed(), 6.0)
	assert_almost_eq(meeting.impulse(), 8.0, 1e-14)
	assert_eq(meeting.lost_energy(), 0.0)
	assert_almost_eq(_one_to_two(0.5).lost_energy(), 9.0, 1e-14)
	assert_almost_eq(_one_to_two(0.0).lost_energy(), 12.0, 1e-14)


func test_any_bounce_keeps_momentum_and_the_part_across_and_loses_what_it_says() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 3
	for number: int in 200:
		var meeting := _random(rng)
		var after := meeting.velocities_after()
		assert_vec2(meeting.momentum_of(after), meeting.momentum(), 1e-12)
		var lost := meeting.energy() - meeting.energy_of(after)
		assert_almost_eq(lost, meeting.lost_energy(), 1e-11)
		var parting := after[1].minus(after[0]).dot(meeting.normal)
		assert_almost_eq(parting, meeting.bounciness * meeting.closing_speed(), 1e-12)
		var across := meeting.normal.normal()
		assert_almost_eq(after[0].dot(across), meeting.one.velocity.dot(across), 1e-12)
		assert_almost_eq(after[1].dot(across), meeting.two.velocity.dot(across), 1e-12)


func test_the_impulse_leads_to_the_same_velocities() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 4
	for number: int in 100:
		var meeting := _random(rng)
		var push := meeting.normal.scaled(meeting.impulse())
		var one := meeting.one.velocity.minus(push.divided(meeting.one.mass))
		assert_vec2(one, meeting.velocities_after()[0], 1e-12)


static func _one_to_two(bounciness: float) -> BallMeeting:
	var one := Ball.new(Vec2.new(-1.0, 0.0), 1.0, Vec2.new(6.0, 0.0), 1.0)
	var two := Ball.new(Vec2.new(sqrt(2.0), 0.0), sqrt(2.0), Vec2.new(), 2.0)
	return BallMeeting.new(one, two, bounciness)


# They approach: what parts is turned round.
static func _random(rng: RandomNumberGenerator) -> BallMeeting:
	var normal := Vec2.unit_radians(rng.randf() * TAU)
	var one := Ball.new(Vec2.new(), 1.0, _vector(rng), rng.randf_range(0.1, 9.0))
	var two := Ball.new(normal.scaled(2.0), 1.0, _vector(rng), rng.randf_range(0.1, 9.0))
	var meeting := BallMeeting.new(one, two, rng.randf())
	if meeting.closing_speed() < 0.0:
		one.velocity.scale(-1.0)
		two.velocity.scale(-1.0)
	return meeting


static func _vector(rng: RandomNumberGenerator) -> Vec2:
	return Vec2.new(rng.randf_range(-5.0, 5.0), rng.randf_range(-5.0, 5.0))
