extends ScreenTest
## A demo starts with the lesson frame alone. It opens the first lesson that there is, and offers no
## way back.


func test_it_opens_the_first_lesson_that_there_is() -> void:
	await _open(_demo())
	var opened := frame()
	assert_same(opened.lesson_info, LessonIndex.lessons()[0])
	assert_not_null(opened.lesson)
	assert_reads("1  " + LessonIndex.lessons()[0].title)


func test_it_offers_no_way_back() -> void:
	await _open(_demo())
	assert_null(Screen.button(screen(), "Back to the lessons"))
	await student.press(&"lab_back")
	assert_not_null(frame())


func test_it_fills_the_window() -> void:
	await _open(_demo())
	for size: Vector2i in [Vector2i(1280, 720), Vector2i(720, 1280)]:
		await resize(size)
		assert_eq(screen().size, Vector2(size))


func _demo() -> Node:
	return (load("res://scenes/shell/lesson_frame.tscn") as PackedScene).instantiate()
