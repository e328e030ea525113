extends LabTest
## What a script's text names: comments and the insides of strings do not count.

const WrittenCode := preload("res://tools/export/written_code.gd")


func test_a_name_in_code_counts_once() -> void:
	assert_eq(WrittenCode.names_in("Ball.new()\nBall.new()"), PackedStringArray(["Ball"]))


func test_a_name_in_a_comment_or_a_string_does_not_count() -> void:
	for code: String in ["# Ball", "## [Ball]", '"Ball"', "'Ball'", '"""a\nBall"""', r'"\" Ball"']:
		assert_eq(WrittenCode.names_in(code), PackedStringArray(), code)


func test_a_sign_for_a_comment_within_a_string_begins_none() -> void:
	assert_has(WrittenCode.names_in('"#" + Ball'), "Ball")


func test_a_nodes_and_a_members_name_do_not_count() -> void:
	for code: String in ["%Ball", "$Ball", "$Board/Ball", "self.Ball"]:
		assert_does_not_have(WrittenCode.names_in(code), "Ball", code)


func test_strings_of_every_form_are_found_without_their_quotes() -> void:
	var code := 'a = "one" # "no"\nb = \'two\'\nc = """three"""\nd = &"four"'
	assert_eq(WrittenCode.strings_in(code), PackedStringArray(["one", "two", "three", "four"]))
