extends LessonTest
## The smallest lesson, with which others begin.


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"smallest_lesson"))


func test_it_starts_with_the_vector_of_its_scene() -> void:
	assert_eq(formula_lines(), PackedStringArray(["v = ( 4 , -3 )", "|v| = √(v · v) = √25 = 5"]))
	assert_reads("|v|")


func test_the_head_can_be_dragged_and_undone() -> void:
	await student.drag(_place(4.0, -3.0), _place(5.0, 12.0))
	assert_eq(_v(), PackedFloat64Array([5.0, 12.0]))
	assert_string_contains(formula_lines()[1], "= 13")
	await student.press(&"lab_undo")
	assert_eq(_v(), PackedFloat64Array([4.0, -3.0]))


func test_a_number_can_be_typed() -> void:
	await student.enter(Screen.named(screen(), "y of v") as LineEdit, "0")
	assert_eq(_v(), PackedFloat64Array([4.0, 0.0]))


func test_it_has_links() -> void:
	await student.enter(Screen.named(screen(), "x of v") as LineEdit, "-7")
	assert_eq(frame().link.text(), "smallest_lesson?v=-7,-3")
	assert_eq(frame().link.open("v=1,2"), "")
	assert_eq(_v(), PackedFloat64Array([1.0, 2.0]))


func _v() -> PackedFloat64Array:
	return frame().lesson.state()["v"]


func _place(x: float, y: float) -> Vector2:
	var board := frame().lesson.board
	return board.get_global_transform() * board.to_screen(Vec2.new(x, y))
