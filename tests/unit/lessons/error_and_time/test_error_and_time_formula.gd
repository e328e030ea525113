extends LabTest
## The formula of the order, read as a student reads it: for two settings with any errors and run
## times its lines give what they say, or it says why there is no order.

const _FORMULA := preload("res://scenes/widgets/services/formula.tscn")
const _PAIRS := 400


func test_every_line_gives_what_it_says() -> void:
	var formula := _FORMULA.instantiate() as Formula
	add_child_autofree(formula)
	var shown := ErrorAndTimeFormula.new(formula)
	var reader := FormulaReader.new(LessonWords.of(&"error_and_time"))
	var rng := RandomNumberGenerator.new()
	rng.seed = 3
	var with_order := 0
	var problems: PackedStringArray = []
	for i in _PAIRS:
		shown.show_order([_random(rng), _random(rng)], 0)
		var lines := Screen.lines(formula)
		with_order += 1 if lines.size() == 4 else 0
		problems.append_array(reader.problems(lines))
		if i % 20 == 0:
			await get_tree().process_frame
	assert_between(with_order, roundi(0.25 * _PAIRS), _PAIRS - 20, "with and without an order")
	assert_eq(problems, PackedStringArray())


func test_it_says_why_there_is_no_order() -> void:
	var formula := _FORMULA.instantiate() as Formula
	add_child_autofree(formula)
	var shown := ErrorAndTimeFormula.new(formula)
	var reasons: Array[String] = []
	for other: Measurement in [
		_measured(2.0, 0.0), _measured(2.0, INF), _measured(1.0, 5.0), _measured(1.00001, 5.0)
	]:
		shown.show_order([_measured(1.0, 1.0), other], 0)
		reasons.append(Screen.lines(formula)[1])
		await get_tree().process_frame
	var same := "Both settings take the same time."
	var wanted: Array[String] = [
		"One of the two errors is 0.", "One of the two settings has no answer.", same, same
	]
	assert_eq(reasons, wanted)


# Sizes that are measured, and now and then a special one.
func _random(rng: RandomNumberGenerator) -> Measurement:
	var error := 10.0 ** rng.randf_range(-16.0, 3.0)
	var time := 10.0 ** rng.randf_range(-1.0, 5.0)
	match rng.randi() % 12:
		0:
			error = 0.0
		1:
			error = INF
		2:
			time = 1000.0
		3:
			time = 1000.0 * (1.0 + 10.0 ** rng.randf_range(-6.0, -1.0))
	return _measured(time, error)


func _measured(run_time_us: float, error: float) -> Measurement:
	var measurement := Measurement.new()
	measurement.method = "one"
	measurement.run_time_us = run_time_us
	measurement.error = error
	return measurement
