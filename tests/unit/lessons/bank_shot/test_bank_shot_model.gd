extends LabTest
## The model of the lesson on bank shots: its ways, its shots, and what it refuses.

const _SEED := 5
const _BOARDS := 40


func test_every_preset_can_be_taken_and_only_one_has_no_way() -> void:
	for preset: String in BankShotModel.PRESETS:
		var model := _model(preset)
		assert_eq(model.answer().way.hit, preset != "No way", preset)
		assert_eq(model.answer().overlapped, -1, preset)


func test_the_first_way_is_the_one_of_the_table() -> void:
	var answer := _model("One bounce").answer()
	assert_vec2(answer.way.images[0], Vec2.new(300, 400), 1e-12)
	assert_vec2(answer.way.bounces[0], Vec2.new(220, 280), 1e-12)
	var image := _model("C = 0.5").answer().way.images[0]
	assert_vec2(image, Vec2.new(300, 520), 1e-12)


func test_shots_miss_by_no_more_than_rounding() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = _SEED
	var hits := 0
	for number: int in _BOARDS:
		var model := _random_board(rng)
		var answer := model.answer()
		if answer.way.hit and answer.overlapped < 0:
			hits += 1
			answer.measure_bound()
			assert_lt(answer.miss(), 4.0 * answer.bound, str(model.to_dictionary()))
	assert_gt(hits, 10)


func test_every_refused_way_names_its_wall() -> void:
	var ways := _model("No way").answer().ways
	assert_eq(ways.map(func(way: BankWay) -> int: return way.outcome), [4, 1, 5])
	assert_eq(ways.map(BankShotAnswer.failing_wall), [0, 1, -1])


func test_an_order_of_two_walls_with_several_sides_shows_the_one_that_gets_farthest() -> void:
	var model := _model("Three bounces")
	assert_eq(model.answer().ways.size(), 12)
	assert_no_refusal(model.take({order = "212"}))
	assert_eq(model.answer().way.walls, PackedInt32Array([1, 0, 1]))
	assert_false(model.answer().way.hit)


func test_the_answer_is_computed_once() -> void:
	var model := _model("One bounce")
	var answer := model.answer()
	assert_same(model.answer(), answer)
	model.board.target = Vec2.new(310, 160)
	assert_not_same(model.answer(), answer)


func test_an_order_that_no_longer_fits_is_given_up() -> void:
	var model := _model("Right angle")
	assert_no_refusal(model.take({order = "12"}))
	assert_no_refusal(model.take({bounces = 3}))
	assert_eq(model.order, "")


func test_what_cannot_be_is_refused_with_the_value() -> void:
	var model := _model("One bounce")
	var refusals: Dictionary[String, Dictionary] = {
		"r must be within 0.01..10000, not 0.": {radius = 0.0},
		"C must be within 0.05..1, not 1.5.": {bounciness = 1.5},
		"bounces must be within 1..3, not 4.": {bounces = 4},
		"(2000000, 0) is too far out": {start = [2e6, 0]},
		"order must be one of 1, 2, not “3”.": {order = "3"},
		"bounces must be within 1..1, not 2.": {walls = [[0, 0, 9, 0]], bounces = 2},
		"walls must be within 1..4, not 0.": {walls = []},
	}
	for sentence in refusals:
		assert_string_contains(model.take(refusals[sentence]), sentence)
	assert_eq(model.board.radius, 20.0)


func test_the_image_on_the_wall_keeps_the_loss() -> void:
	var model := _model("One bounce")
	assert_no_refusal(model.fit_bounciness(Vec2.new(300, 290)))
	assert_eq(model.board.bounciness, 1.0)
	assert_no_refusal(model.fit_bounciness(Vec2.new(300, 20000)))
	assert_eq(model.board.bounciness, BankShotModel.LEAST_BOUNCINESS)


func test_the_error_of_the_direction_is_rounding() -> void:
	var model := _model("Slanted pair")
	var way := model.answer().way
	assert_lt(model.board.error_of(way), 1e-15)
	way.direction.rotate_radians(1e-9)
	assert_almost_eq(model.board.error_of(way), 1e-9, 1e-15)


static func _model(preset: String) -> BankShotModel:
	var model := BankShotModel.new()
	model.board.walls.append(LineSegment.new(Vec2.zero(), Vec2.new(1, 0)))
	Refusal.push(model.take(BankShotModel.PRESETS[preset]))
	return model


# A preset in which everything has moved a little.
static func _random_board(rng: RandomNumberGenerator) -> BankShotModel:
	var presets := PackedStringArray(BankShotModel.PRESETS.keys())
	var model := _model(presets[rng.randi() % presets.size()])
	for point: Vec2 in model.board.points():
		point.add(Vec2.random_unit(rng).scaled(rng.randf_range(0, 12)))
	var state := model.to_dictionary()
	state["bounciness"] = rng.randf_range(0.6, 1.0)
	model.from_dictionary(state)
	return model
