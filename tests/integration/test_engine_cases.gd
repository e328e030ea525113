extends LabTest
## The engine's own bodies fly the shots of the report: from the right place, for the right time.

## In pixels. The engine's 32-bit numbers and its margin of 0.08 px allow nothing closer.
const TOLERANCE := 0.1


func after_each() -> void:
	assert_eq(Engine.physics_ticks_per_second, 60, "the old rate is back")
	var spaces := get_children().filter(func(child: Node) -> bool: return child is EngineSpace)
	assert_eq(spaces, [], "nothing is left in the tree")


func test_a_free_flight_is_right_by_every_method_at_every_rate() -> void:
	for rate: int in [60, 240]:
		var shot := BoxShot.new(300.0, 0.1)
		for case in (
			EngineShotCases.moved(self, shot, rate) + EngineShotCases.rigid(self, shot, rate, false)
		):
			@warning_ignore("redundant_await")
			await case.run_once()
			case.finish()
			assert_lt(case.error, 1e-3, "%s, %s" % [case.method, case.tuning])
			assert_true(case.is_baseline)


func test_a_few_bounces_end_about_where_they_should() -> void:
	var shot := BoxShot.new(300.0, 2.0)
	for case in EngineShotCases.moved(self, shot, 240):
		@warning_ignore("redundant_await")
		await case.run_once()
		assert_lt(case.error, 1.0, case.method)


func test_a_fast_rigid_body_leaves_the_box() -> void:
	var case := RigidFlight.new(self, RigidBody2D.CCD_MODE_DISABLED, BoxShot.new(30000.0, 1.0), 60)
	await case.run_once()
	assert_eq(case.error, Measurement.NO_ANSWER)


func test_a_rigid_body_among_lines_is_compared_frame_by_frame() -> void:
	var shot := LinesShot.new()
	shot.seconds = 0.5
	shot.path_seconds = 1.0
	var case := RigidFlight.new(self, RigidBody2D.CCD_MODE_DISABLED, shot, 240)
	await case.run_once()
	assert_between(case.figures["bounces"], 1.0, 10.0, case.note)


func test_a_body_moved_among_many_segments_is_near_the_exact_path() -> void:
	var case := CollideFlight.new(self, true, ManySegmentsShot.new(64), 60)
	await case.run_once()
	await case.run_once()
	case.finish()
	assert_lt(case.error, 20.0)
	assert_gt(case.error, 0.0)


func test_a_dropped_rigid_body_comes_to_rest_on_the_floor() -> void:
	var case := RigidDrop.new(self, 0.5, 60)
	await case.run_once()
	assert_lt(case.error, 1.0)
	assert_lt(absf(case.figures["energy"]), 0.01)


func test_two_rigid_bodies_count_the_first_digit_of_pi() -> void:
	var case := RigidPi.new(self, 0, 60)
	await case.run_once()
	assert_eq(case.error, 0.0, case.note)


func test_rigid_balls_keep_about_their_energy_and_overlap() -> void:
	var case := RigidCrowd.new(self, Crowd.new(10, 1.0), 60)
	await case.run_once()
	assert_between(case.error, 0.0, 20.0)
	assert_lt(case.figures["energy drift"], 0.1)
	assert_between(case.figures["reversed"], 1.0 / 60.0, 1.0)


func test_a_vector2_projects_to_32_bits() -> void:
	var case := Vector2Projection.new(ProjectionPairs.EASY, true)
	case.run_once()
	assert_between(case.error, 1e-9, 1e-6)


func test_every_problem_has_a_case_of_the_engine() -> void:
	for problem in ReportProblems.all():
		for is_quick: bool in [true, false]:
			var cases := EngineCases.of(problem.id, is_quick, self)
			cases.append_array(EngineAimCases.of(problem.id, is_quick))
			assert_gt(cases.size(), 0, problem.id)
			for case in cases:
				assert_eq([case.problem, case.is_baseline], [problem.id, true])
