extends ScreenTest
## Who steps forward while a lesson still moves by itself reads its own numbers, those of the
## lecture; who has chosen others keeps them.

# A frame may be very short: so many at most until what moves has got away from its start.
const _FRAMES := 600
const _FEW_FRAMES := 20
## Only something moves there, and none of the numbers changes.
const _KEEPS_ITS_NUMBERS: Array[StringName] = [
	&"reflection",
	&"lead_target",
	&"newton_balls",
	&"slide_and_roll",
	&"collision_friction",
	&"moving_platforms",
]


func before_each() -> void:
	super()
	OpeningMotion.is_allowed = true
	Motion.reduce(false)


func after_each() -> void:
	OpeningMotion.is_allowed = false
	await super()


func test_the_first_step_forward_is_at_the_start(id: StringName = use_parameters(_ids())) -> void:
	var start := await _start_of(id)
	for way: String in ["N", "button", "gamepad", "other keys before"]:
		await _open_moved(id)
		assert_eq(_lesson().state() == start, id in _KEEPS_ITS_NUMBERS, "%s has moved" % id)
		if way == "other keys before":
			await student.press_key(KEY_M)
			await student.press_key(KEY_H)
		await _go_forward(way)
		assert_eq(_lesson().state(), start, "%s: %s" % [id, way])
		assert_false(OpeningMotion.is_running, id)
		assert_true((frame().get_node("%Undo") as Button).disabled, "%s: nothing to undo" % id)
		screen().free()


func test_what_was_played_stays(id: StringName = use_parameters(_ids())) -> void:
	var start := await _start_of(id)
	await _open_moved(id)
	var transport: Transport = _lesson().services.get(&"transport")
	if not transport or not transport.visible:
		pass_test("%s plays nothing at its first step" % id)
		return
	await student.press(&"lab_pause")
	await student.press_key(KEY_N)
	assert_eq(_lesson().state() == start, id in _KEEPS_ITS_NUMBERS, id)


func test_what_was_picked_stays(id: StringName = use_parameters(_ids())) -> void:
	var start := await _start_of(id)
	await _open_moved(id)
	_lesson().finish_edit()
	var chosen := _lesson().state()
	await student.press_key(KEY_N)
	assert_eq(_lesson().state(), chosen, id)
	assert_eq(chosen == start, id in _KEEPS_ITS_NUMBERS, id)


func test_a_dragged_head_stays() -> void:
	await _open_moved(&"dot_product")
	await student.drag(_head_on_screen(), _place(Vec2.new(3, 4)))
	await student.press_key(KEY_N)
	assert_eq(_a(), PackedFloat64Array([3, 4]))


func test_what_was_undone_and_redone_stays() -> void:
	await _open_moved(&"dot_product")
	await student.press(&"lab_undo")
	assert_eq(_a(), PackedFloat64Array([7, 1]))
	await student.press(&"lab_redo")
	var redone := _a()
	await student.press_key(KEY_N)
	assert_eq(_a(), redone)
	assert_ne(redone, PackedFloat64Array([7, 1]))


func test_the_board_of_a_link_stays() -> void:
	LessonRequest.ask("#dot_product?a=3,4")
	await _open_moved(&"dot_product")
	await student.press_key(KEY_N)
	assert_eq(_a(), PackedFloat64Array([3, 4]))


func test_a_link_that_names_only_the_lesson_changes_nothing() -> void:
	LessonRequest.ask("#dot_product")
	await _open_moved(&"dot_product")
	assert_ne(_a(), PackedFloat64Array([7, 1]))
	await student.press_key(KEY_N)
	assert_eq(_a(), PackedFloat64Array([7, 1]))


# The lessons that move by themselves and have steps.
func _ids() -> Array[StringName]:
	var ids: Array[StringName] = []
	for info in LessonIndex.lessons():
		var code := FileAccess.get_file_as_string(info.scene_path().get_basename() + ".gd")
		if code.contains("open_with(") and info.needs.has("steps"):
			ids.append(info.id)
	return ids


func _start_of(id: StringName) -> Dictionary:
	OpeningMotion.is_allowed = false
	await open_lesson(LessonIndex.find(id))
	var start := _lesson().state()
	screen().free()
	OpeningMotion.is_allowed = true
	return start


# Opens a lesson and waits until it has left where it starts.
func _open_moved(id: StringName) -> void:
	await open_lesson(LessonIndex.find(id))
	var state := _lesson().state()
	for frame_number: int in _FRAMES if OpeningMotion.is_running else 0:
		await get_tree().process_frame
		if _lesson().state() != state or id in _KEEPS_ITS_NUMBERS and frame_number > _FEW_FRAMES:
			return


func _go_forward(way: String) -> void:
	if way == "button":
		await student.click(_lesson().services[&"steps"].get_node(^"%Forward") as Control)
	elif way == "gamepad":
		await student.press_pad(JOY_BUTTON_X)
	else:
		await student.press_key(KEY_N)


func _lesson() -> Lesson:
	return frame().lesson


func _a() -> PackedFloat64Array:
	return _lesson().state()["a"]


func _head_on_screen() -> Vector2:
	return _place(Vec2.new(_a()[0], _a()[1]))


func _place(point: Vec2) -> Vector2:
	return _lesson().get_global_transform() * _lesson().board.to_screen(point)
