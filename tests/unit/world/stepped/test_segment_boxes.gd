extends LabTest
## Tests that the quick rejection of far segments changes nothing: the bits are the same as when
## every segment is looked at.


## The readable way: looks at every segment.
class LookAtAllMover:
	extends WholeFrameMover

	func fly_clear(_ball: Ball, _seconds: float, _surroundings: Surroundings) -> bool:
		return false

	func find_impact(
		ball: Ball, motion: Vec2, surroundings: Surroundings, skipped: PackedInt32Array
	) -> Impact:
		var places: PackedInt32Array = []
		var candidates: Array[LineSegment] = []
		for i in surroundings.segments.size():
			if not i in skipped:
				places.append(i)
				candidates.append(surroundings.segments[i])
		var impact := SegmentImpact.with_segments(ball.position, motion, ball.radius, candidates)
		if impact.hit:
			impact.segment_index = places[impact.segment_index]
		return impact


func test_ten_balls_run_to_the_same_bits_as_when_all_lines_are_looked_at() -> void:
	for bounciness: float in [1.0, 0.7, 0.0]:
		var quick := SteppedWorlds.box(10, 21)
		assert_no_refusal(quick.surroundings.set_bounciness(bounciness))
		var readable := quick.copy()
		readable.mover = LookAtAllMover.new()
		SteppedWorlds.run(quick, 240)
		SteppedWorlds.run(readable, 240)
		assert_eq(quick.state(), readable.state(), "C = %s" % bounciness)


func test_no_segment_with_an_impact_is_rejected() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 77
	var hits := 0
	var missed := 0
	for i in 4000:
		var start := _place(rng)
		var segment := LineSegment.new(start, start.plus(_place(rng)))
		var position := _place(rng)
		var motion := _place(rng)
		if SegmentImpact.with_segment(position, motion, 10.0, segment).hit:
			hits += 1
			missed += int(SegmentBoxes.new([segment]).near(position, motion, 10.0).is_empty())
	assert_gt(hits, 400)
	assert_eq(missed, 0)


func test_most_far_segments_are_rejected() -> void:
	var surroundings := SteppedWorlds.box(1, 2).surroundings
	var near := surroundings.near_segments(Vec2.new(-10.0, -150.0), Vec2.new(4.0, 2.0), 6.0)
	assert_lt(near.size(), 2, "of %d" % surroundings.segments.size())


func test_segments_that_are_left_out_are_not_near() -> void:
	var ball := Ball.new(Vec2.new(), 5.0)
	var world := SteppedWorlds.world([Vector4(-9, 1, 9, 1), Vector4(-9, 2, 9, 2)], ball)
	var near := world.surroundings.near_segments(Vec2.new(), Vec2.new(), 5.0, [0])
	assert_eq(near, PackedInt32Array([1]))


func _place(rng: RandomNumberGenerator) -> Vec2:
	return Vec2.new(rng.randf_range(-60, 60), rng.randf_range(-60, 60))
