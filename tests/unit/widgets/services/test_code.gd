extends LabTest
## What the lines of GDScript beside a formula say when they are run.

var _code: LessonCode


func before_each() -> void:
	_code = (load("res://scenes/widgets/services/code.tscn") as PackedScene).instantiate()
	add_child_autofree(_code)
	_code.folded = false


func test_a_variable_says_what_it_is_and_the_next_line_uses_it() -> void:
	var lines: PackedStringArray = [
		"var scalar := a.dot(b.normalized())", "var p := b.normalized().scaled(scalar)"
	]
	_code.show_code(lines, {"a": Vec2.new(7.0, 1.0), "b": Vec2.new(8.0, -6.0)})
	assert_eq(
		_text(),
		"var scalar := a.dot(b.normalized())   # 5\nvar p := b.normalized().scaled(scalar)   # (4, −3)"
	)


func test_a_verb_says_what_its_vector_is_then_and_leaves_the_lessons_vector_alone() -> void:
	var v := Vec2.new(3.0, 4.0)
	_code.show_code(["v.reflect(n)"], {"v": v, "n": Vec2.new(0.0, 1.0)})
	assert_eq(_text(), "v.reflect(n)   # (3, −4)")
	assert_vec2(v, Vec2.new(3.0, 4.0), 0.0)


func test_a_line_that_is_neither_is_only_shown() -> void:
	_code.show_code(["if t >= 0.0 and t <= 1.0:"], {"t": 0.5})
	assert_eq(_text(), "if t >= 0.0 and t <= 1.0:")


func test_results_are_hidden_with_the_answers() -> void:
	_code.hides_numbers = true
	_code.show_code(["var c := a + 1.0"], {"a": 1.0})
	assert_eq(_text(), "var c := a + 1.0   # ?")


func test_a_class_can_be_used_by_its_name() -> void:
	_code.show_code(
		["var far := LineDistance.signed_distance(c, line)"],
		{
			"LineDistance": LineDistance,
			"c": Vec2.new(0.0, 5.0),
			"line": LineSegment.new(Vec2.new(0.0, 0.0), Vec2.new(9.0, 0.0))
		}
	)
	assert_eq(_text(), "var far := LineDistance.signed_distance(c, line)   # 5")


func test_a_line_that_cannot_be_run_is_an_error() -> void:
	_code.show_code(["var c := a.no_such_method()"], {"a": Vec2.new(1.0, 1.0)})
	assert_push_error("a.no_such_method()")


func test_what_is_folded_away_is_run_when_it_is_unfolded() -> void:
	_code.folded = true
	_code.show_code(["var c := a + 1.0"], {"a": 1.0})
	assert_eq(_text(), "")
	_code.folded = false
	_code.folding_changed.emit(false)
	assert_eq(_text(), "var c := a + 1.0   # 2")


func _text() -> String:
	return (_code.get_node("%Text") as Label).text
