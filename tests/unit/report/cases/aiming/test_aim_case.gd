extends LabTest
## Cases of aiming: the run time of a shot, the largest miss, and what finds no shot.


func test_the_error_is_the_largest_miss() -> void:
	var case := _case([0.25, 3.0, 0.5])
	case.run_once()
	assert_eq(case.error, 3.0)
	assert_eq(case.note, "2 of 3 shots within 1 px")
	assert_gt(case.result().run_time_us, 0.0)


func test_a_shot_that_is_not_found_leaves_no_answer() -> void:
	var case := _case([0.25, NAN, 0.5])
	case.run_once()
	assert_eq(case.error, Measurement.NO_ANSWER)
	assert_eq(case.note, "2 of 3 shots within 1 px, none found for 1")


func test_it_has_a_name_and_a_tuning() -> void:
	var case := _case([1.0]).named("by hand", "60 Hz")
	assert_eq([case.method, case.setting, case.problem], ["by hand", "easy, 60 Hz", "fake"])


# Questions whose shots miss by so much.
func _case(misses: Array[float]) -> AimCase:
	var questions: Array[Measurement] = []
	for miss: float in misses:
		questions.append(Measurement.new())
		questions[-1].error = miss
	var solver := func(_asked: Measurement) -> int: return 7
	var miss := func(asked: Measurement, shot: int) -> float: return asked.error * shot / 7.0
	return AimCase.new("fake", "easy", questions, solver, miss)
