extends LabTest
## A case keeps its runs, and its result is what the report shows.


func test_the_run_time_is_the_median_of_the_runs() -> void:
	var case := _Still.new()
	for time: float in [5.0, 1.0, 400.0, 2.0, 3.0]:
		case.keep_run(time)
	assert_eq(case.result().run_time_us, 3.0)
	assert_eq(case.runs(), 5)


func test_the_median_of_an_even_number_is_between_the_middle_two() -> void:
	assert_eq(MeasuredCase.median([4.0, 1.0, 2.0, 9.0]), 3.0)


func test_the_median_of_nothing_is_zero() -> void:
	assert_eq(MeasuredCase.median([]), 0.0)


func test_the_result_tells_problem_method_setting_and_error() -> void:
	var case := _Still.new()
	case.problem = "a problem"
	case.method = "a method"
	case.situation = "300 px/s"
	case.tuning = "60 Hz"
	case.is_baseline = true
	case.error = 0.25
	case.figures["drift"] = 2.0
	var result := case.result()
	assert_eq([result.problem, result.method, result.error], ["a problem", "a method", 0.25])
	assert_eq([result.setting, case.setting], ["300 px/s, 60 Hz", "300 px/s, 60 Hz"])
	assert_true(result.is_baseline)
	assert_eq(result.figures, {"drift": 2.0} as Dictionary[String, float])


func test_a_result_does_not_change_with_later_runs() -> void:
	var case := _Still.new()
	case.keep_run(1.0)
	var early := case.result()
	case.keep_run(100.0)
	case.figures["drift"] = 1.0
	assert_eq(early.run_time_us, 1.0)
	assert_eq(early.figures.size(), 0)


func test_a_setting_without_tuning_is_the_situation() -> void:
	assert_eq(Measurement.setting_of("10 balls", ""), "10 balls")


func test_a_case_whose_world_refused_has_no_answer_and_no_run_time() -> void:
	var case := _Still.new()
	case.keep_run(1.0)
	case.error = 0.25
	case.figures["drift"] = 2.0
	case.keep_refusal("")
	assert_eq(case.result().error, 0.25, "no refusal")
	case.keep_refusal("The world stops here.")
	case.keep_refusal("And here again.")
	var result := case.result()
	assert_false(result.has_answer())
	assert_eq([result.run_time_us, result.note], [Measurement.NO_ANSWER, "The world stops here."])
	assert_eq(result.figures.size(), 0)


func test_no_case_measures_a_world_that_has_stopped() -> void:
	var going_on := _JammedShot.new()
	going_on.goes_on = true
	going_on.path_seconds = 1.0
	for case: MeasuredCase in [
		_JammedFlight.new(_JammedShot.new()),
		_JammedFlight.new(going_on),
		_JammedFollowedFlight.new(_JammedShot.new()),
	]:
		for run: int in 2:
			case.run_once()
		var result := case.result()
		assert_string_contains(result.note, "more than 100 impacts within a second")
		assert_eq([result.has_answer(), result.run_time_us], [false, Measurement.NO_ANSWER])
		case.finish()
	# A world that has stopped says so at each new moment.
	assert_push_error_count(61)


func test_no_case_measures_a_world_that_took_nothing() -> void:
	var shot := _JammedShot.new()
	shot.ball.radius = -1.0
	for case: MeasuredCase in [
		EventFlight.new(EventFlight.Form.GRID, "", shot, 60),
		SteppedFlight.new(SteppingMethods.Method.WHOLE_FRAME, shot, 60),
	]:
		for run: int in 5:
			case.run_once()
		assert_eq(case.result().note, "A ball's radius must be above 0 and finite, not -1.0.")
		assert_false(case.result().has_answer())


## A ball between two lines that touches both: infinitely many impacts.
class _JammedShot:
	extends Shot

	func _init() -> void:
		ball = Ball.new(Vec2.new(), 5.0, Vec2.new(0.0, 1000.0))
		seconds = 1.0

	func segments() -> Array[LineSegment]:
		return [
			LineSegment.new(Vec2.new(-50.0, 5.0), Vec2.new(50.0, 5.0)),
			LineSegment.new(Vec2.new(-50.0, -5.0), Vec2.new(50.0, -5.0)),
		]

	func judge(case: MeasuredCase, _end: Vec2, _path: PackedFloat64Array) -> void:
		case.error = 0.0


class _JammedFlight:
	extends EventFlight

	func _init(of_shot: Shot) -> void:
		super(EventFlight.Form.GRID, "", of_shot, 60)

	func _prepare() -> void:
		super()
		_world.most_impacts_per_second = 100


class _JammedFollowedFlight:
	extends FollowedFlight

	func _init(of_shot: Shot) -> void:
		super(EventFlight.Form.GRID, "", of_shot, 60)

	func _prepare() -> void:
		super()
		_world.most_impacts_per_second = 100


class _Still:
	extends MeasuredCase

	func run_once() -> void:
		keep_run(1.0)
