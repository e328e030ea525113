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


func _count() -> void:
	_calls += 1
