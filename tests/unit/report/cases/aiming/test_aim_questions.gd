extends LabTest
## What is asked of the ways to aim, and by how much a shot misses: the numbers of the slides.

const _GRAVITY := 300.0


func test_a_lead_misses_by_the_distances_of_the_slide() -> void:
	var target := AimTarget.new(Vec2.new(240, 0), Vec2.new(0, 90))
	var asked := AimQuestion.new(Vec2.zero(), target, 150.0, Vec2.zero(), 10.0)
	assert_almost_eq(asked.time, 2.0, 1e-14)
	assert_eq(
		asked.miss(Vec2.new(0.8, 0.6)), asked.miss_of(Aim.at(2.0, Vec2.new(4, 3), Vec2.zero()))
	)
	assert_lt(asked.miss(Vec2.new(0.8, 0.6)), 1e-13)
	assert_almost_eq(asked.miss(Vec2.new(1, 0)), 123.5, 0.05)
	assert_true(is_nan(asked.miss_of(Aim.miss(Aim.Outcome.OUTRUN))))
	assert_true(is_nan(asked.miss(Vec2.new(NAN, 0))))


func test_a_shot_under_gravity_hits_by_both_arcs() -> void:
	var gravity := Vec2.new(0, _GRAVITY)
	var target := AimTarget.new(Vec2.new(200, 0))
	var asked := AimQuestion.new(Vec2.zero(), target, 250.0, gravity, 10.0)
	assert_lt(asked.miss(Vec2.new(0.8, -0.6)), 1e-13)
	assert_lt(asked.miss(Vec2.new(0.6, -0.8)), 1e-13)
	# The sign of g is wrong: it flies below.
	assert_gt(asked.miss(Vec2.new(0.8, 0.6)), 100.0)


func test_a_shot_over_a_wall_misses_by_the_distances_of_the_slide() -> void:
	var asked := BankQuestion.new()
	asked.start = Vec2.new(100, 100)
	asked.target = Vec2.new(300, 160)
	asked.radius = 20.0
	asked.bounciness = 1.0
	asked.bounces = 1
	asked.walls = [LineSegment.new(Vec2.new(-500, 300), Vec2.new(900, 300))]
	assert_lt(asked.miss_of(BankQuestions.careful(asked)), 1e-13)
	# The radius forgotten, and the wall's middle aimed at.
	assert_almost_eq(asked.miss(_way(Vec2.new(100, 100), Vec2.new(300, 440))), 20.3, 0.05)
	assert_almost_eq(asked.miss(_way(Vec2.new(100, 100), Vec2.new(200, 280))), 29.1, 0.05)
	asked.bounciness = 0.5
	assert_lt(asked.miss_of(BankQuestions.careful(asked)), 1e-13)
	assert_almost_eq(asked.miss(_way(Vec2.new(100, 100), Vec2.new(300, 400))), 48.0, 0.05)


func test_a_ball_that_does_not_bounce_misses_by_its_distance() -> void:
	var asked := BankQuestion.new()
	asked.start = Vec2.zero()
	asked.target = Vec2.new(30, 40)
	asked.radius = 5.0
	asked.bounciness = 1.0
	asked.bounces = 1
	asked.walls = [LineSegment.new(Vec2.new(-500, 300), Vec2.new(900, 300))]
	assert_eq(asked.miss(Vec2.new(0, -1)), 50.0)


func test_a_shot_that_is_timed_misses_by_the_distances_of_the_slide() -> void:
	var asked := TimedQuestion.new()
	asked.muzzle = Vec2.new(300, 400)
	asked.angle = -PI / 2
	asked.speed = 200.0
	asked.target = AimTarget.new(Vec2.new(0, 200), Vec2.new(100, 0))
	asked.solve()
	assert_lt(asked.miss(2.0), 1e-13)
	# When it is in front.
	assert_almost_eq(asked.miss(3.0), 89.4, 0.05)
	var in_front := FramewiseTiming.in_front(asked, 60)
	assert_almost_eq(in_front.fire, 3.0, 1.0 / 60)
	assert_almost_eq(FramewiseTiming.ahead(asked, 60).fire, 2.0, 1.0 / 60)


func test_every_situation_has_questions_that_the_careful_way_answers_to_the_last_bits() -> void:
	for problem: ReportProblem in [
		LeadShotProblem.new(),
		BallisticShotProblem.new(),
		BankShotProblem.new(),
		TimedShotProblem.new()
	]:
		for case in problem.cases(true):
			if case.method == problem.champion:
				case.run_once()
				assert_lt(case.error, 1e-11, "%s: %s" % [problem.id, case.setting])


func test_the_slide_loses_digits_where_speeds_are_nearly_equal_and_finds_nothing_straight_up(
) -> void:
	for case in LeadShotProblem.new().cases(true):
		if case.method == LeadShotProblem.BY_THE_SLIDE and case.situation == LeadQuestions.EQUAL:
			case.run_once()
			assert_gt(case.error, 1e-8)
	for case in BallisticShotProblem.new().cases(true):
		if case.method == BallisticShotProblem.BY_THE_SLIDE:
			if case.situation == BallisticQuestions.ABOVE:
				case.run_once()
				assert_eq(case.error, Measurement.NO_ANSWER)


func test_frames_are_off_by_up_to_a_frame() -> void:
	for asked in LeadQuestions.of(LeadQuestions.SLOW, true):
		for rate: int in [60, 240]:
			var aim := FramewiseAim.first(asked, rate)
			assert_between(aim.time - asked.time, -1e-9, 1.0 / rate)


func test_more_directions_come_nearer() -> void:
	var asked := BankQuestions.of(BankQuestions.ONE, true)[0]
	var few := asked.miss(TriedDirections.best(asked, 60))
	assert_lt(asked.miss(TriedDirections.best(asked, 960)), few)


func _way(from: Vec2, to: Vec2) -> Vec2:
	return to.minus(from).normalized()
