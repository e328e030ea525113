extends LabTest
## The mistakes of the lesson on bank shots miss by what geometry says.


func test_the_radius_forgotten_misses_by_20() -> void:
	var answer := _answer("One bounce", BankShotMistakes.RADIUS_FORGOTTEN)
	assert_almost_eq(answer.wrong_corners[1].x, 100.0 + 200.0 * 180.0 / 340.0, 1e-9)
	# The ball aims at (300, 440) and comes up from there mirrored.
	assert_almost_eq(answer.wrong_miss(), 8000.0 / Vec2.new(200, 340).length(), 1e-9)


func test_the_middle_misses_by_29() -> void:
	var answer := _answer("One bounce", BankShotMistakes.MIDPOINT)
	assert_almost_eq(answer.wrong_corners[1].x, 200.0, 1e-9)
	assert_almost_eq(answer.wrong_miss(), 6000.0 / Vec2.new(100, 180).length(), 1e-9)


func test_the_plain_mirror_misses_by_48() -> void:
	assert_almost_eq(_answer("C = 0.5", BankShotMistakes.PLAIN_MIRROR).wrong_miss(), 48.0, 1e-9)


func test_the_wrong_order_misses_where_walls_are_slanted() -> void:
	assert_gt(_answer("Slanted pair", BankShotMistakes.WRONG_ORDER).wrong_miss(), 20.0)


func test_a_right_angle_hides_the_wrong_order() -> void:
	var answer := _answer("Right angle", BankShotMistakes.WRONG_ORDER)
	assert_false(answer.mistake_shows())
	assert_lt(answer.wrong_miss(), 1e-9)


func test_with_a_point_the_radius_is_no_mistake() -> void:
	var model := _model("One bounce")
	assert_no_refusal(model.take({radius = 0.01, mistake = BankShotMistakes.RADIUS_FORGOTTEN}))
	assert_lt(model.answer().wrong_miss(), 0.02)


func test_a_mistake_that_changes_nothing_brings_a_board_on_which_it_does() -> void:
	for info in BankShotMistakes.infos():
		var model := _model("Right angle")
		model.show_mistake(info.number)
		assert_true(model.answer().mistake_shows(), info.title)


static func _model(preset: String) -> BankShotModel:
	var model := BankShotModel.new()
	model.board.walls.append(LineSegment.new(Vec2.zero(), Vec2.new(1, 0)))
	Refusal.push(model.take(BankShotModel.PRESETS[preset]))
	return model


static func _answer(preset: String, mistake: int) -> BankShotAnswer:
	var model := _model(preset)
	model.mistake = mistake
	return model.answer()
