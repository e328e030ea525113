extends LabTest
## What a case says about its trial: passed, failed or refused.


## A family with one case for each outcome.
class GivenFamily:
	extends StabilityFamily

	func cases() -> Array[StabilityCase]:
		return [
			_case(
				"equal", "0", func(_is_quick: bool) -> StabilityResult: return _at_most(0.0, 0.0)
			),
			_case("more", "1", func(_is_quick: bool) -> StabilityResult: return _at_most(2.0, 1.0)),
			_case("none", "1", func(_is_quick: bool) -> StabilityResult: return _at_most(NAN, 1.0)),
			_case("refused", "0", _refused),
			_case("quick", "yes", _quick).with_quick_form("shorter"),
		]

	func _refused(_is_quick: bool) -> StabilityResult:
		var world := _world([], [_ball(0.0, 0.0, 0.0, 0.0, -3.0)])
		return _at_most(world.energy(), 0.0)

	func _quick(is_quick: bool) -> StabilityResult:
		return StabilityResult.new(str(is_quick), is_quick)


func test_a_figure_within_the_bound_has_passed_and_one_beyond_or_none_has_not() -> void:
	var verdicts := GivenFamily.new().cases().map(
		func(case: StabilityCase) -> bool: return case.run().passed
	)
	assert_eq(verdicts, [true, false, false, false, false])


func test_what_the_world_refuses_is_the_figure_of_a_failed_case() -> void:
	var result := GivenFamily.new().cases()[3].run()
	assert_false(result.passed)
	assert_eq(result.figure, "A ball's radius must be above 0 and finite, not -3.0.")


func test_a_refusal_is_forgotten_by_the_next_case() -> void:
	var cases := GivenFamily.new().cases()
	cases[3].run()
	assert_true(cases[0].run().passed)


func test_the_quick_form_is_named_and_asked_for() -> void:
	var case := GivenFamily.new().cases()[4]
	assert_eq([case.is_long, case.title_in_brief()], [true, "shorter"])
	assert_eq([case.run(true).figure, case.run().figure], ["true", "false"])
	assert_true(case.has_quick_form())


func test_a_long_case_may_have_no_quick_form_and_keeps_its_title() -> void:
	var case := GivenFamily.new().cases()[0]
	assert_true(case.has_quick_form(), "a short case is its own")
	case.without_quick_form()
	assert_eq([case.is_long, case.has_quick_form()], [true, false])
	assert_eq(case.title_in_brief(), "equal")


func test_what_is_tried_in_brief_is_told_apart_from_every_other_case() -> void:
	var titles: PackedStringArray = []
	for case in StabilityCases.all():
		if case.has_quick_form():
			assert_does_not_have(titles, case.title_in_brief())
			titles.append(case.title_in_brief())


func test_every_case_says_what_is_tried_and_what_must_hold() -> void:
	var titles: PackedStringArray = []
	for case in StabilityCases.all():
		assert_ne(case.criterion, "", case.title)
		assert_does_not_have(titles, case.title)
		titles.append(case.title)
	assert_gt(titles.size(), 60)


func test_a_star_room_tells_how_deep_inside_or_outside_a_point_is() -> void:
	var room := StarRoom.new()
	assert_eq(room.sides.size(), 14)
	assert_gt(room.depth_of(0.0, 0.0), 100.0)
	assert_almost_eq(room.depth_of(300.0, 0.0), 0.0, 1e-9)
	assert_almost_eq(room.depth_of(310.0, 0.0), -10.0, 1e-9)
	assert_false(room.depth_of(NAN, 0.0) >= 0.0)
	# Between two tips a point is outside, although it is nearer to the middle than the tips are.
	assert_lt(room.depth_of(250.0 * cos(TAU / 14.0), 250.0 * sin(TAU / 14.0)), -20.0)


func test_the_depth_is_the_distance_to_the_nearest_side() -> void:
	var room := StarRoom.new()
	for point in random_vectors(7, 50, 320.0):
		var nearest := INF
		for side in room.sides:
			nearest = minf(nearest, side.closest_point(point).distance_to(point))
		assert_almost_eq(absf(room.depth_of(point.x, point.y)), nearest, 1e-9)
