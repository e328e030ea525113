extends LabTest
## Two blocks and a wall, as the report counts their impacts.


func test_from_impact_to_impact_every_digit_is_right() -> void:
	for n in 5:
		var case := EventPi.new(n)
		case.run_once()
		assert_eq(case.error, 0.0, case.note)
		assert_lt(case.figures["energy drift"], 1e-12)


func test_the_right_counts_are_the_digits_of_pi() -> void:
	for n in PiCase.RIGHT_COUNTS.size():
		assert_eq(PiCase.RIGHT_COUNTS[n], floori(PI * 10.0 ** n))


func test_steps_miss_impacts_the_more_the_larger_they_are() -> void:
	var coarse := SteppedPi.new(2, 60)
	var fine := SteppedPi.new(2, 15360)
	coarse.run_once()
	fine.run_once()
	assert_gt(coarse.error, 100.0)
	assert_lt(fine.error, 0.2 * coarse.error)
	assert_string_contains(coarse.note, "314 are right")


func test_all_is_over_within_the_time_that_is_stepped() -> void:
	for n in 5:
		var blocks := TwoBlocks.new()
		assert_eq(blocks.start(100.0 ** n), "")
		assert_false(blocks.run(100000), "no impact follows")
		assert_lt(blocks.time, PiCase.SECONDS)


func test_the_full_form_goes_to_seven_and_the_quick_one_to_five() -> void:
	assert_eq(DigitsOfPiProblem.numbers(false), PackedInt32Array([0, 1, 2, 3, 4, 5, 6, 7]))
	assert_eq(DigitsOfPiProblem.numbers(true), PackedInt32Array([0, 1, 2, 3, 4, 5]))
	assert_eq(DigitsOfPiProblem.new().cases(true).size(), 6 * 4)
