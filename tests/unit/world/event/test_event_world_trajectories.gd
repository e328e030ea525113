extends LabTest
## Whole flights of the event world, compared with reference trajectories that were worked out with
## 140 digits.

## The largest error of an end that is allowed, in multiples of how far a relative change of EPSILON
## in the start moves that end.
const _BOUND := 200.0

## At this amplification, in pixels, the bound would allow an error of 44 px: doubles cannot follow
## such a flight. [ExactPath] can.
const _HOPELESS := 1e15


func test_bounces_and_ends_agree_as_far_as_doubles_can_follow() -> void:
	var errors := PackedFloat64Array()
	for case: ReferenceTrajectory in _followed():
		var world := _world(case)
		assert_eq(world.impacts, case.bounces, case.title)
		var error := world.position(0).distance_to(case.end)
		errors.append(error / (EPSILON * case.amplification))
	var sorted := errors.duplicate()
	sorted.sort()
	gut.p(
		"worst end of %d flights: %s EPSILON times the amplification" % [errors.size(), sorted[-1]]
	)
	assert_all_at_most(errors, _BOUND)


func test_nearly_all_reference_flights_can_be_followed() -> void:
	assert_gt(_followed().size(), ReferenceTrajectory.all().size() - 4)


func test_the_speed_is_kept_on_every_flight() -> void:
	var drifts := PackedFloat64Array()
	for case in ReferenceTrajectory.all():
		var speed := _world(case).velocity(0).length()
		drifts.append(absf(speed / case.ball.velocity.length() - 1.0))
	assert_all_at_most(drifts, 1e-14)


func _followed() -> Array[ReferenceTrajectory]:
	return ReferenceTrajectory.all().filter(
		func(case: ReferenceTrajectory) -> bool: return case.amplification < _HOPELESS
	)


func _world(case: ReferenceTrajectory) -> EventWorld:
	var world := EventWorld.new()
	assert_no_refusal(world.set_segments(case.segments))
	assert_no_refusal(world.set_balls([case.ball]))
	assert_no_refusal(world.advance(case.seconds))
	return world
