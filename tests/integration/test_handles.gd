extends ScreenTest
## Handles that can be taken, in every lesson: large enough for a finger at every size, named for
## screen readers, reached with the Tab key.

const _SMALLEST := 44.0
## More than the parts that can take the focus in any lesson.
const _MOST_TABS := 200
const _SIZES: Array[Vector2i] = [
	Vector2i(1280, 720), Vector2i(1920, 1080), Vector2i(800, 600), Vector2i(720, 1280)
]


func test_every_handle_takes_a_finger_44_pixels_wide() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		await open_lesson(lesson)
		for size: Vector2i in _SIZES:
			await resize(size)
			for handle: Handle in _handles():
				var text := "%s of %s at %s" % [handle.title, lesson.id, size]
				assert_gte(_width(handle), _SMALLEST, text)
		screen().free()


func test_every_handle_has_a_name_for_screen_readers_and_a_tooltip() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		await open_lesson(lesson)
		for handle: Handle in _handles():
			assert_ne(handle.accessibility_name, "", "%s in %s" % [handle.get_path(), lesson.id])
			assert_eq(handle.tooltip_text, handle.accessibility_name)
		screen().free()


func test_handles_are_reached_by_tab_in_every_lesson() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		await open_lesson(lesson)
		var reached := await _reached_by_tab()
		for handle: Handle in _handles():
			assert_has(reached, handle, "%s of %s" % [handle.title, lesson.id])
		screen().free()


# What has the focus on one whole round with the Tab key.
func _reached_by_tab() -> Array[Control]:
	var reached: Array[Control] = []
	var start := Screen.button(screen(), "Put the board back to its start")
	start.grab_focus()
	await student.press_key(KEY_TAB)
	while not start.has_focus() and reached.size() < _MOST_TABS:
		reached.append(student.window.gui_get_focus_owner())
		await student.press_key(KEY_TAB)
	return reached


# How wide the handle is for a touch, across its narrow side, in pixels of the window.
func _width(handle: Handle) -> float:
	var scale := student.window.get_final_transform().get_scale().x
	if handle is ArrowBody:
		return 2.0 * ArrowBody.REACH * scale
	return minf(handle.size.x, handle.size.y) * scale


func _handles() -> Array[Handle]:
	var found: Array[Handle] = []
	for control: Control in Screen.controls(frame().lesson):
		if control is Handle and control.focus_mode == Control.FOCUS_ALL:
			found.append(control as Handle)
	return found
