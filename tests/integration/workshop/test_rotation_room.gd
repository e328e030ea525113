extends WorkshopTest
## The board of exercise 0: the lab's answer and, dashed, the student's own.

const _RIGHT := """var old := x
	x = old * cos(angle) - y * sin(angle)
	y = old * sin(angle) + y * cos(angle)"""
const _LATE := """x = x * cos(angle) - y * sin(angle)
	y = x * sin(angle) + y * cos(angle)"""
const _AROUND := """x -= point.x
	y -= point.y
	rotate(angle)
	x += point.x
	y += point.y"""


func test_without_code_only_the_lab_answers() -> void:
	await judged()
	await _open_board()
	assert_vec2(_head("%Right"), Vec2.new(-5.0, 2.0), 1e-6)
	assert_false((screen().get_node("%Own") as Arrow).visible)
	assert_reads("Write rotate in my_vec2.gd.")


func test_a_right_answer_lies_on_the_labs() -> void:
	write("rotate", _RIGHT)
	write("rotate_around", _AROUND)
	await _open_with_answer()
	assert_vec2(_head("%Own"), Vec2.new(-5.0, 2.0), 1e-6)
	assert_reads("The lab: (−5, 2)   yours: (−5, 2)  ✓")


func test_a_wrong_answer_lies_where_the_method_puts_it() -> void:
	write("rotate", _LATE)
	await _open_with_answer()
	assert_vec2(_head("%Own"), Vec2.new(-5.0, -5.0), 1e-6)
	assert_true((screen().get_node("%Own") as Arrow).dashed)
	assert_reads("yours: (−5, −5)  ✗")
	assert_reads("y is computed with the x that has changed already: keep the old x first.")


func test_around_a_point() -> void:
	write("rotate", _RIGHT)
	write("rotate_around", _AROUND)
	await _open_with_answer()
	await click_button("Around the point p")
	await _answer()
	assert_vec2(_head("%Right"), Vec2.new(-2.0, 1.0), 1e-6)
	assert_vec2(_head("%Own"), Vec2.new(-2.0, 1.0), 1e-6)


func test_it_is_asked_anew_where_the_vector_is_moved_and_the_angle_typed() -> void:
	write("rotate", _RIGHT)
	await _open_with_answer()
	await student.enter(screen().get_node("%Angle") as LineEdit, "180")
	await _answer()
	assert_vec2(_head("%Own"), Vec2.new(-2.0, -5.0), 1e-6)
	Screen.named(screen(), "Head of v").grab_focus()
	await student.press_key(KEY_RIGHT)
	await _answer()
	assert_vec2(_head("%Own"), Vec2.new(-3.0, -5.0), 1e-6)


func test_an_answer_to_what_is_no_longer_asked_is_not_shown() -> void:
	write("rotate", _RIGHT)
	await _open_with_answer()
	watcher.answered.emit(-7, PackedFloat64Array([9.0, 9.0]))
	assert_vec2(_head("%Own"), Vec2.new(-5.0, 2.0), 1e-6)


func _open_board() -> void:
	WorkshopWays.open_rotation(get_tree())
	await student.settle()


func _open_with_answer() -> void:
	await judged()
	await _open_board()
	await _answer()


func _answer() -> void:
	var own := screen().get_node("%Own") as Arrow
	await until(func() -> bool: return own.visible)


func _head(arrow: String) -> Vec2:
	return Vec2.from_vector2((screen().get_node(arrow) as Arrow).head)
