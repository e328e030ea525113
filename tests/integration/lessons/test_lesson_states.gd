extends ScreenTest
## The states in which lessons are looked at: all that can be picked, and special places of points.

const _COUNT := 300


func test_they_are_the_same_for_the_same_seed_and_can_all_be_shown() -> void:
	await open_lesson(LessonIndex.find(&"line_distance"))
	var lesson := frame().lesson
	var first := lesson.state()
	var states := LessonStates.new(lesson, 4)
	assert_eq(lesson.state(), first, "the lesson is left as it was")
	var again := LessonStates.new(lesson, 4)
	for i in _COUNT:
		var state := states.state(i)
		assert_eq(again.state(i), state)
		assert_eq(lesson.link_problem(state), "")


func test_each_preset_mistake_and_switch_is_among_them() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	var found := LessonStates.new(frame().lesson, 4).bases
	for preset: Dictionary in DotProductModel.PRESETS.values():
		var heads: Array = preset["a"]
		assert_true(found.any(_has.bind("a", PackedFloat64Array(heads))), str(preset))
	for key: String in ["normalizes", "is_swapped"]:
		for value: bool in [false, true]:
			assert_true(found.any(_has.bind(key, value)), key)
	screen().free()
	await open_lesson(LessonIndex.find(&"line_distance"))
	found = LessonStates.new(frame().lesson, 4).bases
	for mistake in LineDistanceMistakes.infos():
		assert_true(found.any(_has.bind("mistake", mistake.number)), mistake.title)


func test_points_lie_in_special_places_to_each_other() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	var states := LessonStates.new(frame().lesson, 4)
	var zero := 0
	var right := 0
	var nearly_right := 0
	var huge := 0
	for i in _COUNT:
		var state := states.state(i)
		var a := _vector(state, "a")
		var b := _vector(state, "b")
		var sizes := a.length() * b.length()
		zero += int(sizes == 0.0)
		right += int(sizes > 0.0 and absf(a.dot(b)) < 1e-14 * sizes)
		nearly_right += int(absf(a.dot(b)) > 1e-14 * sizes and absf(a.dot(b)) < 2e-3 * sizes)
		huge += int(a.length() > 1e14)
	for count: int in [zero, right, nearly_right, huge]:
		assert_gt(count, 4)


func _vector(state: Dictionary, letter: String) -> Vec2:
	var head: PackedFloat64Array = state[letter]
	var tail: PackedFloat64Array = state[letter + "_from"]
	return Vec2.new(head[0] - tail[0], head[1] - tail[1])


func _has(state: Dictionary, key: String, value: Variant) -> bool:
	return state[key] == value
