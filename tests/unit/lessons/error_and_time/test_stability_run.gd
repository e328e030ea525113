extends LabTest
## Tests of trying stiff and extreme cases one after the other.


## Cases with known outcomes.
class FakeFamily:
	extends StabilityFamily

	func cases() -> Array[StabilityCase]:
		var found: Array[StabilityCase] = []
		for outcome: bool in [true, false, true]:
			var trial := func(_is_quick: bool) -> StabilityResult:
				return StabilityResult.new("7 px", outcome)
			found.append(_case("a case", "holds", trial))
			found.append(_case("long", "holds", trial).without_quick_form())
		return found


func test_cases_are_tried_in_their_order_and_those_that_hold_are_counted() -> void:
	var run := StabilityRun.new(FakeFamily.new().cases())
	run.is_going = true
	run.advance(1_000_000)
	var passed := run.results.map(func(result: StabilityResult) -> bool: return result.passed)
	assert_eq(passed, [true, false, true])
	assert_eq(run.passed_count(), 2)
	assert_eq(run.first_failure(), 1)
	assert_true(run.is_done())


func test_a_long_case_without_a_quick_form_is_neither_tried_nor_counted() -> void:
	var run := StabilityRun.new(FakeFamily.new().cases())
	assert_eq([run.size(), run.left_out.size()], [3, 3])
	assert_eq(run.left_out[0].title, "long")


func test_a_slice_tries_one_case_at_least_and_can_be_stopped_after_it() -> void:
	var run := StabilityRun.new(FakeFamily.new().cases())
	run.is_going = true
	run.advance(0)
	run.is_going = false
	run.advance(0)
	assert_eq(run.done_count(), 1)
	assert_almost_eq(run.share(), 1.0 / 3.0, 1e-12)
