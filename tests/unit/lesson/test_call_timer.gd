extends LabTest
## The run time of a call. How long it is depends on the machine and is not tested.

var _calls := 0


func test_the_time_is_finite_and_not_negative() -> void:
	var vector := Vec2.new(3, 4)
	for function: Callable in [_count, vector.length, func() -> void: pass]:
		var time := CallTimer.nanoseconds(function)
		assert_true(is_finite(time))
		assert_gte(time, 0.0)


func test_the_function_is_called_many_times() -> void:
	_calls = 0
	CallTimer.nanoseconds(_count)
	assert_gt(_calls, 100)


func test_a_clock_that_goes_in_large_steps_still_tells_the_time_of_a_call() -> void:
	_calls = 0
	# Each call takes 300 ns, and the clock goes on every 100 us.
	var clock := func() -> int: return floori(_calls * 0.3 / 100.0) * 100
	assert_almost_eq(CallTimer.fastest_by(clock, _count), 300.0, 35.0)


func test_a_call_that_takes_no_time_comes_to_an_end() -> void:
	assert_eq(CallTimer.fastest_by(func() -> int: return 0, _count), 0.0)


func _count() -> void:
	_calls += 1
