extends ScreenTest
## The plan of docs/teaching.md can be held: it is walked link by link, as a teacher pastes them
## into the open lab, and each opens what its row speaks of.

const TeachingPlan := preload("res://tools/web/teaching_plan.gd")

const _HIDES := "answers=off"
const _NAMES_ANSWERS := "answers="
const _ASKS_AT_ONCE := "Page Down asks"
const _PARTS := 19

var _plan := TeachingPlan.new()
var _clipboard := ""


func before_all() -> void:
	super()
	LinkPaste.clipboard = func() -> String: return _clipboard


func after_all() -> void:
	LinkPaste.clipboard = DisplayServer.clipboard_get


func after_each() -> void:
	LessonRequest.ask("")
	LabText.speak(LabText.ENGLISH)
	await super.after_each()


func test_rows_follow_each_other_in_steps_of_a_few_minutes() -> void:
	assert_gt(_plan.rows.size(), 40, "rows are found")
	for place in _plan.rows.size():
		var row := _plan.rows[place]
		assert_eq(row.number, place + 1)
		assert_between(row.minutes, 1, 4, "minutes of row %d" % row.number)
		for text: String in [row.part, row.link, row.show, row.ask, row.answer, row.rubric]:
			assert_ne(text, "", "row %d" % row.number)


func test_every_part_of_the_lecture_has_a_row() -> void:
	for part in range(1, _PARTS + 1):
		var has_part := func(row: TeachingPlan.Row) -> bool: return row.part == str(part)
		assert_true(_plan.rows.any(has_part), "part %d" % part)


func test_shorter_versions_take_their_rows_in_order_and_fit() -> void:
	assert_eq(_plan.versions.keys(), [50, 30])
	for minutes in _plan.versions:
		var numbers := _plan.versions[minutes]
		assert_between(_plan.minutes_of(numbers), minutes - 2, minutes)
		for place in range(1, numbers.size()):
			assert_gt(numbers[place], numbers[place - 1])


func test_no_row_leaves_the_answers_of_the_next_one_hidden() -> void:
	var ways: Array[PackedInt32Array] = [PackedInt32Array(range(1, _plan.rows.size() + 1))]
	ways.append_array(_plan.versions.values())
	for numbers in ways:
		for place in range(1, numbers.size()):
			var before := _plan.rows[numbers[place - 1] - 1]
			var row := _plan.rows[numbers[place] - 1]
			if before.link.contains(_HIDES):
				assert_string_contains(row.link, _NAMES_ANSWERS)


func test_the_plan_is_walked_in_one_open_lab() -> void:
	await open_start_screen()
	for row in _plan.rows:
		await _paste(row.link)
		_assert_shows(row)
		await _assert_asks(row)


func test_a_link_shows_the_same_board_whatever_was_shown_before() -> void:
	await open_start_screen()
	var walked: Dictionary[int, Dictionary] = {}
	for row in _plan.rows:
		await _paste(row.link)
		walked[row.number] = frame().lesson.link_state()
	for row in _plan.rows:
		screen().free()
		LessonBoards.forget_all()
		LessonRequest.ask(row.link)
		await open_lesson(LessonIndex.find(LessonRequest.take_id()))
		assert_eq(frame().lesson.link_state(), walked[row.number], "row %d" % row.number)


func test_the_plan_is_walked_in_dutch_on_a_phone() -> void:
	await resize(Vector2i(390, 844))
	await open_start_screen()
	for row in _plan.rows:
		await _paste(row.link + "&lang=nl")
		assert_eq(LabText.language(), "nl")
		_assert_shows(row)


func _paste(link: String) -> void:
	_clipboard = "#" + link
	await student.press_key(KEY_V, false, true)
	await student.settle()


func _assert_shows(row: TeachingPlan.Row) -> void:
	var about := "row %d, %s" % [row.number, row.link]
	assert_not_null(frame(), about)
	if not frame():
		return
	assert_eq(str(frame().lesson_info.id), row.link.get_slice("?", 0), about)
	assert_eq(frame().lesson.step + 1, row.link.get_slice("step=", 1).to_int(), about)
	assert_eq((frame().get_node(^"%Notice") as Label).text, "", about)
	if row.link.contains(_NAMES_ANSWERS):
		assert_eq(frame().view.shows_answers, not row.link.contains(_HIDES), about)


# What a row says that the next page asks, it asks.
func _assert_asks(row: TeachingPlan.Row) -> void:
	if not row.show.contains(_ASKS_AT_ONCE):
		return
	var step := frame().lesson.step
	await student.press_key(KEY_PAGEDOWN)
	var about := "row %d asks before the next step" % row.number
	var steps: Steps = frame().lesson.services[&"steps"]
	var is_asking: bool = steps.get(&"_is_asking")
	assert_true(is_asking, about)
	assert_eq(frame().lesson.step, step, about)
	await student.press_key(KEY_PAGEDOWN)
	assert_eq(frame().lesson.step, step + 1, about)
