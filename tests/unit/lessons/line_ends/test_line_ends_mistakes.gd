extends LabTest
## The bug gallery of the lesson on line ends: every mistake is wrong in the way that the course
## describes, and the test that the gallery names catches it.


func test_every_mistake_shows_in_the_shot_that_tells_it() -> void:
	for number: int in LineEndsMistakes.NUMBERS:
		var model := _telling_model(number)
		assert_true(LineEndsMistakes.shows(number, model), "mistake %d" % number)


func test_a_squared_discriminant_gives_the_fraction_of_the_course() -> void:
	var fraction := LineEndsMistakes.impact(18, _telling_model(18)).fraction
	assert_almost_eq(fraction, -64799.0, 0.5)


func test_an_untested_discriminant_leaves_no_ball() -> void:
	var impact := LineEndsMistakes.impact(19, _telling_model(19))
	assert_true(is_nan(impact.fraction))
	assert_false(impact.position.is_finite())


func test_a_fraction_from_the_new_position_is_a_whole_frame_too_small() -> void:
	assert_almost_eq(LineEndsMistakes.impact(20, _telling_model(20)).fraction, -0.5, 1e-15)


func test_an_end_tested_too_late_bounces_in_the_air() -> void:
	var impact := LineEndsMistakes.impact(22, _telling_model(22))
	assert_eq(impact.feature, Impact.Feature.LINE)
	assert_almost_eq(impact.fraction, 0.1975, 1e-4)


func test_a_line_without_ends_bounces_in_the_air() -> void:
	var impact := LineEndsMistakes.impact(23, _telling_model(23))
	assert_eq(impact.feature, Impact.Feature.LINE)


func test_no_mistake_changes_a_ball_that_moves_away() -> void:
	var model := LineEndsModel.new()
	model.motion = Vec2.new(-3, -8)
	for number: int in LineEndsMistakes.NUMBERS:
		assert_false(LineEndsMistakes.shows(number, model), "mistake %d" % number)


func test_the_gallery_has_every_mistake_once_and_names_tests_that_exist() -> void:
	var numbers: Array[int] = []
	for info: MistakeInfo in LineEndsMistakeTexts.infos():
		numbers.append(info.number)
		var parts := info.test.split(".")
		var path := "res://tests/unit/collision/%s.gd" % parts[0]
		var code := FileAccess.get_file_as_string(path)
		assert_string_contains(code, "func %s(" % parts[1])
	assert_eq(numbers, LineEndsMistakes.NUMBERS)


static func _telling_model(number: int) -> LineEndsModel:
	var model := LineEndsModel.new()
	LineEndsPresets.lay(model, LineEndsMistakeTexts.telling_preset(number))
	return model


func test_at_the_start_a_line_without_ends_does_what_the_late_test_does_so_it_brings_a_shot(
) -> void:
	var model := LineEndsModel.new()
	assert_true(LineEndsMistakes.is_seen(22, model))
	assert_true(LineEndsMistakes.shows(23, model))
	assert_false(LineEndsMistakes.is_seen(23, model))
	LineEndsPresets.lay(model, LineEndsMistakeTexts.telling_preset(23))
	assert_true(LineEndsMistakes.is_seen(23, model))
