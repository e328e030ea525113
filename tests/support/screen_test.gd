class_name ScreenTest
extends LabTest
## The base of tests that open a screen of the lab in a window of a real size and act on it.

const START_SCREEN := "res://scenes/shell/start_screen.tscn"
const _LESSON_FRAME := "res://scenes/shell/lesson_frame.tscn"
const _USUAL_SIZE := Vector2i(1280, 720)

## Acts on the window; a new one for each test.
var student: Student


# The test runner's own panel lies on top of everything and would take the clicks.
func before_all() -> void:
	for layer: Node in get_tree().root.find_children("*", "CanvasLayer", true, false):
		(layer as CanvasLayer).hide()
	# What opens a lesson moves only in a test that asks for it.
	OpeningMotion.is_allowed = false
	# Two test runs at once keep their choices apart.
	KeptChoices.file = "user://choices_in_tests_%d.cfg" % OS.get_process_id()
	# The engine sleeps that long after each frame when no window is drawn.
	OS.low_processor_usage_mode_sleep_usec = 1


func before_each() -> void:
	# Error and run time are folded until somebody wants them: these tests read them.
	KeptChoices.keep("numbers", true)
	student = Student.new(get_tree().root)
	student.window.size = _USUAL_SIZE
	student.move_to(Vector2.ZERO)


func after_each() -> void:
	student.window.gui_release_focus()
	LessonBoards.forget_all()
	if get_tree().current_scene:
		get_tree().current_scene.free()
	# A second lesson would take the keys of the next test, too.
	for left: Node in get_tree().root.get_children():
		if left is LessonFrame and not left.is_queued_for_deletion():
			fail_test("a lesson is left open")
			left.free()
	# The start screen's cards watch the student's files. The next test has files of its own.
	for watcher: Node in get_tree().root.find_children("*", "WorkshopWatcher", false, false):
		watcher.free()
	for choice: Conventions.Choice in Conventions.Choice.values():
		if Conventions.is_chosen(choice):
			Conventions.choose(choice, false)
	# The next test begins without a language that a link or a button has chosen.
	LabText.speak(LabText.ENGLISH)
	DirAccess.remove_absolute(KeptChoices.file)
	KeptChoices.read_again()
	await student.settle()


## The screen that is open now.
func screen() -> Control:
	return get_tree().current_scene as Control


func open_start_screen() -> void:
	await _open((load(START_SCREEN) as PackedScene).instantiate())


## Opens a lesson in a lesson frame.
func open_lesson(lesson: LessonInfo) -> void:
	var new_frame := (load(_LESSON_FRAME) as PackedScene).instantiate() as LessonFrame
	new_frame.lesson_info = lesson
	await _open(new_frame)


## Goes forward to a step of the lesson, counted from 0; else to the last one. Answers no question.
func go_to_step(step: int = 1000) -> void:
	(frame().lesson.services[&"steps"] as Steps).go_to(step)
	await student.settle()


## The lesson frame that is open now; null on the start screen.
func frame() -> LessonFrame:
	return screen() as LessonFrame


func resize(size: Vector2i) -> void:
	student.window.size = size
	await student.settle()


func click_button(text: String) -> void:
	var button := Screen.button(screen(), text)
	assert_not_null(button, "a button “%s” is there" % text)
	if button:
		await student.click(button)


## Opens the menu of the lesson frame and picks the entry that begins with this text.
func pick_in_view_menu(text: String) -> void:
	var menu := frame().view.menu
	await student.click(menu)
	var popup := menu.get_popup()
	for entry: int in popup.item_count:
		if popup.get_item_text(entry).begins_with(text):
			for step: int in entry + 1:
				if popup.get_focused_item() != entry:
					await student.press_key(KEY_DOWN)
			assert_eq(popup.get_focused_item(), entry)
			await student.press_key(KEY_ENTER)
			return
	assert_true(false, "an entry “%s” is in the menu" % text)


func assert_reads(text: String) -> void:
	assert_true(Screen.reads(screen(), text), "“%s” can be read" % text)


func assert_does_not_read(text: String) -> void:
	assert_false(Screen.reads(screen(), text), "“%s” is not shown" % text)


func _open(scene: Node) -> void:
	get_tree().root.add_child(scene)
	get_tree().current_scene = scene
	await student.settle()
