extends ScreenTest
## Handles of every lesson: large enough for a finger at every size, named for screen readers, hit
## where they are seen.

const _SMALLEST := 44.0
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
		var reached: Dictionary[String, bool] = {}
		Screen.button(screen(), "Reset the lesson").grab_focus()
		for tab: int in _handles().size() + 2:
			await student.press_key(KEY_TAB)
			var owner := student.window.gui_get_focus_owner()
			reached[(owner as Handle).title if owner is Handle else ""] = true
		for handle: Handle in _handles():
			assert_true(reached.has(handle.title), "%s of %s" % [handle.title, lesson.id])
		screen().free()


# Pixels of the window that a touch across the handle may be off, both ways together.
func _width(handle: Handle) -> float:
	var scale := student.window.get_final_transform().get_scale().x
	if handle is ArrowBody:
		return 2.0 * ArrowBody.REACH * scale
	return minf(handle.size.x, handle.size.y) * scale


func _handles() -> Array[Handle]:
	var found: Array[Handle] = []
	for control: Control in Screen.controls(frame().lesson):
		if control is Handle:
			found.append(control as Handle)
	return found
