extends LabTest
## When a flying ball meets a segment that moves, against a dense scan of the flight.

const _SCANS := 3000


func test_paths_and_turning_segments_against_a_dense_scan() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 31
	var hits := 0
	for number: int in 30:
		var start := Vec2.random_unit(rng).scaled(rng.randf_range(0, 100))
		var line := LineSegment.new(start, start.plus(Vec2.random_unit(rng).scaled(80)))
		var motion := _motion(rng, number)
		var moving := motion.begin(_one(line), 0, 0.0, 0.0)
		moving.go_to(0.0, 0.0)
		var away := Vec2.random_unit(rng)
		var ball := Ball.new(away.scaled(rng.randf_range(150, 260)), 7)
		ball.velocity = Vec2.random_unit(rng).scaled(30.0).minus(away.scaled(90.0))
		var gravity := Vec2.new(0, 120) if number % 2 == 0 else Vec2.zero()
		var wanted := _scanned(line, motion, ball, gravity)
		var found := _found(moving, ball, gravity)
		if wanted < INF:
			hits += 1
		assert_almost_eq(minf(found, 9.0), minf(wanted, 9.0), 4.0 / _SCANS, "number %d" % number)
	assert_gt(hits, 5)


static func _motion(rng: RandomNumberGenerator, number: int) -> SegmentMotion:
	if number % 3 == 0:
		var pivot := Vec2.random_unit(rng).scaled(20.0)
		return SegmentMotion.turning(pivot, rng.randf_range(-6, 6), Vec2.random_unit(rng).scaled(9))
	var ways: Array[Vec2] = [Vec2.zero()]
	for place: int in 2:
		ways.append(Vec2.random_unit(rng).scaled(rng.randf_range(0, 60)))
	ways.append(Vec2.zero())
	return SegmentMotion.along([0.0, 0.3, 0.8, 1.1], ways, number % 3 == 1)


static func _one(line: LineSegment) -> SegmentScan:
	var made := SegmentScan.new()
	made.put(0, line)
	return made


# Seconds until the impact within 4 s; INF for none.
static func _found(moving: SegmentScan, ball: Ball, gravity: Vec2) -> float:
	var at := ball.position
	var velocity := ball.velocity
	var is_found := false
	if gravity.y == 0.0:
		is_found = moving.first_impact(at.x, at.y, velocity.x, velocity.y, 7.0, 4.0)
	else:
		is_found = moving.first_accelerated_impact(
			at.x, at.y, velocity.x, velocity.y, gravity.x, gravity.y, 7.0, 4.0
		)
	return moving.time if is_found and moving.index == 0 else INF


static func _scanned(line: LineSegment, motion: SegmentMotion, ball: Ball, gravity: Vec2) -> float:
	var mover := SegmentMover.new(line, motion, 0.0, 0.0)
	for step: int in _SCANS:
		var seconds := 4.0 * step / _SCANS
		mover.go_to(seconds, 0.0)
		var at := ball.position.plus(FreeFlight.motion(ball.velocity, gravity, seconds))
		if mover.segment_now().closest_point(at).distance_to(at) < 7.0:
			return seconds
	return INF
