extends LabTest
## The smallest distance between a bullet and its target, against a search along the flight.

const _SHOTS := 40
const _SEED := 5
const _LONGEST := 4.0


func test_a_shot_past_a_target_that_rests() -> void:
	var miss := _miss(Vec2.new(100, 0), Vec2.zero(), AimTarget.new(Vec2.new(200, 30)))
	assert_almost_eq(miss.moment, 2.0, 1e-12)
	assert_almost_eq(miss.distance, 30.0, 1e-12)


func test_a_shot_that_flies_away_is_nearest_at_its_start() -> void:
	var miss := _miss(Vec2.new(-100, 0), Vec2.zero(), AimTarget.new(Vec2.new(200, 30)))
	assert_eq(miss.moment, 0.0)


func test_a_target_that_only_comes_nearer_is_nearest_at_the_end() -> void:
	var miss := _miss(Vec2.new(10, 0), Vec2.zero(), AimTarget.new(Vec2.new(200, 0)))
	assert_eq(miss.moment, _LONGEST)
	assert_almost_eq(miss.distance, 160.0, 1e-12)


func test_one_that_flies_along_keeps_its_distance() -> void:
	var target := AimTarget.new(Vec2.new(3, 4), Vec2.new(100, 0))
	assert_almost_eq(_miss(Vec2.new(100, 0), Vec2.zero(), target).distance, 5.0, 1e-12)


func test_no_moment_of_the_flight_is_nearer() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = _SEED
	for number: int in _SHOTS:
		var velocity := Vec2.random_unit(rng).scaled(rng.randf_range(50, 300))
		var gravity := Vec2.new(0, rng.randf_range(0, 300))
		var target := AimTarget.new(
			Vec2.random_unit(rng).scaled(200),
			Vec2.random_unit(rng).scaled(rng.randf_range(0, 100)),
			Vec2.new(0, 300) if rng.randf() < 0.3 else Vec2.zero()
		)
		var miss := _miss(velocity, gravity, target)
		var shot := FiredShot.new(Vec2.zero(), velocity, gravity)
		var searched := ShotSearch.nearest_moment(shot, target.position_after, _LONGEST)
		var least := shot.distance_after(searched, target.position_after)
		assert_almost_eq(miss.distance, least, 1e-6, "shot %d" % number)


func _miss(velocity: Vec2, gravity: Vec2, target: AimTarget) -> ShotMiss:
	return ShotMiss.of(Vec2.zero(), velocity, gravity, target, _LONGEST)
