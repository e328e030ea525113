extends LabTest
## Whole flights of the event world, against the reference trajectories worked out with 140 digits.

## What the end may be off, in units in the last place per unit of relative change in the start.
const _BOUND := 200.0

## From here on a change in the last place of the start moves the end by more than the world is
## large: no double follows such a flight, and [ExactPath] is the one that does.
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
	gut.p("worst end of %d flights: %s eps of the amplification" % [errors.size(), sorted[-1]])
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
