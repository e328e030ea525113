extends LabTest
## Two hand-ins have the same shape if one is a copy of the other under other names, and only then.

const _HEAD := "class_name MyVec2\nextends RefCounted\n\nvar x := 0.0\nvar y := 0.0\n\n"
const _DOT := "func dot(other: MyVec2) -> float:\n\treturn x * other.x + y * other.y\n"
const _LENGTH := "func own_length() -> float:\n\tvar size := x * x\n\treturn sqrt(size + y * y)\n"


func test_names_blanks_comments_and_order_do_not_count() -> void:
	var copy := _HEAD + "# my own\n" + _LENGTH + "\n\n" + _DOT
	for word: String in ["other", "size", "own_length"]:
		copy = copy.replace(word, word + "_2")
	assert_eq(_shape(copy).sum, _shape(_HEAD + _DOT + _LENGTH).sum)


func test_what_is_computed_counts() -> void:
	var code := _HEAD + _DOT + _LENGTH
	for other: String in [
		code.replace("x * other.x + y * other.y", "x * other.y + y * other.x"),
		code.replace("x * other.x + y", "x * other.x - y"),
		code.replace("sqrt(", "abs("),
		code.replace("return x * other.x", "return 2.0 * x * other.x"),
	]:
		assert_ne(_shape(other).sum, _shape(code).sum)


func test_which_parameter_is_used_counts() -> void:
	var code := _HEAD + "func own(width: float, height: float) -> float:\n\treturn width\n"
	assert_ne(_shape(code.replace("return width", "return height")).sum, _shape(code).sum)


func test_starters_have_no_shape_of_their_own() -> void:
	var starter := _shape(WorkshopFiles.starter("my_vec2.gd"))
	assert_eq(starter.tokens, 0)
	assert_gt(_shape(_HEAD + _DOT).tokens, 10)


func _shape(text: String) -> WorkshopShape:
	return WorkshopShape.new({"my_vec2.gd": WorkshopCode.new(text.to_utf8_buffer())})
