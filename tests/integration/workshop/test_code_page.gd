extends ScreenTest
## The page on which a student writes in the lab itself, as in a browser: he types, it judges.

const _PAGE := preload("res://scenes/workshop/room/code_page.tscn")
const _RIGHT := "func dot(other: MyVec2) -> float:\n\treturn x * other.x + y * other.y\n"
const _MINUS := "func dot(other: MyVec2) -> float:\n\treturn x * other.x - y * other.y\n"
const _SIZES: Array[Vector2i] = [Vector2i(1280, 720), Vector2i(390, 844), Vector2i(844, 390)]

var _page: CodePage


func before_each() -> void:
	super.before_each()
	WorkshopChild.is_allowed = false
	_forget()
	await _open_page()


func after_each() -> void:
	await super.after_each()
	_forget()
	WorkshopChild.is_allowed = true


func test_what_is_typed_is_judged_in_the_page() -> void:
	await _choose(3)
	assert_string_contains(_label("Sentence"), "Write dot")
	await _write(_MINUS)
	assert_string_contains(_label("Sentence"), "subtracted")
	assert_eq(_label("Got"), "62")
	assert_eq(_label("Wanted"), "50")
	await _write(_RIGHT)
	assert_string_contains(_label("Sentence"), "dot is right")
	assert_string_contains(_choice().text, "✓")


func test_a_loop_is_stopped_and_its_line_is_marked_until_something_is_typed() -> void:
	await _choose(3)
	await _write("func dot(other: MyVec2) -> float:\n\twhile true:\n\t\tpass\n\treturn 0.0\n")
	assert_string_contains(_label("Sentence"), "does not come to an end")
	assert_eq(_label("Place"), "line 2")
	assert_gt(_field().get_line_background_color(1).a, 0.0)
	await student.type_text("a")
	assert_eq(_field().get_line_background_color(1).a, 0.0)


func test_a_mistake_in_one_text_leaves_the_others_as_they_are() -> void:
	_keep(3, _RIGHT)
	_keep(9, "func reflect(normal: MyVec2, c := 1.0) -> void:\n\tx -= (1.0 + c) * nothing\n")
	await _reopen()
	await _choose(3)
	assert_string_contains(_label("Sentence"), "dot is right")
	await _choose(9)
	assert_eq(_label("Place"), "line 2")
	assert_string_contains(_label("Sentence"), "nothing is not known")


func test_a_text_that_uses_another_one_waits_for_it() -> void:
	_keep(4, "func scalar_projection(onto: MyVec2) -> float:\n\treturn dot(onto.normalized())\n")
	await _reopen()
	await _choose(4)
	assert_string_contains(_label("Sentence"), "mend that first")


func test_each_text_is_there_again_when_the_page_is_opened_anew() -> void:
	await _choose(3)
	await _write(_MINUS)
	await _choose(4)
	assert_string_contains(_field().text, "func scalar_projection")
	await _reopen()
	assert_string_contains(_field().text, "func scalar_projection", "the exercise is kept")
	await _choose(3)
	assert_eq(_field().text, _MINUS)


func test_back_to_the_stub_can_be_undone() -> void:
	await _choose(3)
	assert_true(_button("Stub").disabled)
	await _write(_MINUS)
	await student.click(_button("Stub"))
	assert_string_contains(_label("Sentence"), "Write dot")
	assert_string_contains(_field().text, "return 0.0")
	await student.click(_button("Undo"))
	assert_eq(_field().text, _MINUS)
	KeptChoices.read_again()
	assert_eq(WorkshopKeptCode.text_of(WorkshopIndex.exercise(3)), _MINUS)


func test_escape_leaves_the_field_and_tab_indents_in_it() -> void:
	await _choose(3)
	await student.click(_field())
	_field().set_caret_line(1)
	_field().set_caret_column(0)
	await student.press_key(KEY_TAB)
	assert_string_contains(_field().get_line(1), "\tfunc dot")
	await student.press_key(KEY_ESCAPE)
	assert_false(_field().has_focus())


func test_prints_are_shown_and_cut_short() -> void:
	await _choose(3)
	await _write(_RIGHT.replace("\treturn", "\tfor i in 40: print('number ', i)\n\treturn"))
	assert_string_contains(_label("Printed"), "number 1")
	assert_string_contains(_label("Printed"), "lines more")


func test_all_parts_fit_into_each_window() -> void:
	for size in _SIZES:
		student.window.size = size
		await student.settle()
		var room := _page.get_viewport_rect()
		for part: String in ["Choice", "Next", "Field", "Check", "Stub", "Said"]:
			var place := (_page.get_node("%" + part) as Control).get_global_rect()
			assert_true(room.encloses(place), "%s of %s at %s" % [part, place, size])
		assert_gt(_field().size.y, 100.0)


func _open_page() -> void:
	_page = _PAGE.instantiate() as CodePage
	add_child_autofree(_page)
	await student.settle()


func _reopen() -> void:
	_page.free()
	WorkshopLabWatcher.of(get_tree()).check_now()
	await _open_page()


func _forget() -> void:
	for exercise in WorkshopKeptCode.exercises():
		_keep(exercise.number, WorkshopKeptCode.stub_of(exercise))
	WorkshopKeptCode.choose(WorkshopIndex.exercise(1))


func _keep(number: int, text: String) -> void:
	WorkshopKeptCode.keep(WorkshopIndex.exercise(number), text)


func _choose(number: int) -> void:
	while not _choice().text.contains("Exercise %d:" % number):
		await student.click(_button("Next"))


# As when it is pasted.
func _write(text: String) -> void:
	await student.click(_field())
	_field().replace_all(text)
	await student.settle()
	await student.press_key(KEY_ENTER, false, true)


func _field() -> CodeField:
	return _page.get_node("%Field")


func _choice() -> OptionButton:
	return _page.get_node("%Choice")


func _button(part: String) -> Button:
	return _page.get_node("%" + part)


func _label(part: String) -> String:
	return (_page.get_node("%" + part) as Label).text
