extends ScreenTest
## Opening a lesson, and a state of its board, from the command line or a browser's address.


func after_each() -> void:
	LessonRequest.ask("")
	await super.after_each()


func test_the_command_line_names_a_lesson() -> void:
	var arguments: PackedStringArray = ["--verbose", "--lesson=dot_product?a=7,1"]
	assert_eq(LessonRequest.text_in_arguments(arguments), "dot_product?a=7,1")


func test_a_command_line_without_a_lesson_asks_for_none() -> void:
	assert_eq(LessonRequest.text_in_arguments(["--verbose", "dot_product"]), "")
	assert_eq(LessonRequest.text_in_arguments([]), "")


func test_a_request_names_a_lesson_and_perhaps_a_state() -> void:
	for row: Array in [
		["dot_product", "dot_product", ""],
		["#dot_product", "dot_product", ""],
		["#dot_product?", "dot_product", ""],
		["#dot_product?a=7,1&b=8,-6", "dot_product", "a=7,1&b=8,-6"],
		["#dot_product%3Fa%3D7%2c1", "dot_product", "a=7,1"],
		["#no%20lesson", "no lesson", ""],
		["#a?b?c", "a", "b&c"],
		["#%FF%zz%", "%ff%zz%", ""],
		["#", "", ""],
		["", "", ""],
	]:
		var text: String = row[0]
		LessonRequest.ask(text)
		assert_eq(LessonRequest.take_id(), str(row[1]), text)
		assert_eq(LessonRequest.take_state(str(row[1])), str(row[2]), text)


func test_a_link_that_a_chat_or_a_mail_has_touched_is_the_same_request() -> void:
	for text: String in [
		"#/dot_product?a=7,1&b=8,-6",
		"#!/dot_product/?a=7,1&b=8,-6",
		"#Dot_Product?A=7,1&B=8,-6",
		"#DOT_PRODUCT?A=7,1&B=8,-6",
		"#dot_product?a=7,1&amp;b=8,-6",
		"#dot_product?a=7,1&#38;b=8,-6",
		"#dot_product%3Fa=7%2C1%26b=8,-6",
		"#dot_product%3fa%3d7%2c1%26amp%3bb%3d8%2c-6",
		"#dot_product?a=7,1&b=8,-6.",
		"#dot_product?a=7,1&b=8,-6).",
		"<#dot_product?a=7,1&b=8,-6>",
		"(“#dot_product?a=7,1&b=8,-6”)",
		"https://example.org/lab/index.html?fbclid=x#dot_product?a=7,1&b=8,-6",
		"<https://example.org/lab/#/dot_product?a=7,1&b=8,-6>,",
		" #dot_product?a=7,1&b=8,-6\n",
		"#dot\\_product?a=7,1&b=8,\\-6",
		"**#dot_product?a=7,1&b=8,-6**",
		"`#dot_product?a=7,1&b=8,-6`",
		"»#dot_product?a=7,1&b=8,-6/«…",
		"#dot_product?a=7,1&b=8,-6\u200b",
		"\u202a#dot_product?a=7,1&b=8,-6\u202c\u00a0",
		"#dot_product?a=7,1&b=8,-6#",
		"#dot_product?a=7,1&\r\n b=8, -6",
		"#dot_pro\nduct?a=7,1&b=8,-6",
		"#dot_product?a=7,1&%0D%0Ab=8,-6",
		"#dot_product?a=7,1&amp;amp;b=8,-6",
		"#dot_product%253Fa%253D7%252C1%2526b%253D8%252C-6",
		"https://example.org/url?q=https://example.org/lab/%23dot_product?a=7,1%26b=8,-6",
	]:
		LessonRequest.ask(text)
		assert_eq(LessonRequest.take_id(), "dot_product", text)
		assert_eq(LessonRequest.take_state("dot_product"), "a=7,1&b=8,-6", text)


func test_signs_of_numbers_survive_an_address() -> void:
	LessonRequest.ask("#dot_product?a=+3,%E2%88%924&b=%EF%BC%91,0")
	assert_eq(LessonRequest.take_state("dot_product"), "a=+3,−4&b=１,0")


func test_a_state_is_given_to_its_lesson_only_and_only_once() -> void:
	LessonRequest.ask("dot_product?a=7,1")
	assert_eq(LessonRequest.take_state("normals"), "")
	assert_eq(LessonRequest.take_state("dot_product"), "")
	LessonRequest.ask("dot_product?a=7,1")
	assert_eq(LessonRequest.take_state("dot_product"), "a=7,1")
	assert_eq(LessonRequest.take_state("dot_product"), "")


func test_the_lesson_asked_for_is_opened() -> void:
	await open_start_screen()
	await _request("dot_product")
	assert_eq(frame().lesson_info.id, &"dot_product")


func test_the_state_asked_for_is_opened_from_the_start_screen() -> void:
	LessonRequest.ask("dot_product?a=3,4")
	await open_start_screen()
	await student.settle()
	var a: PackedFloat64Array = frame().lesson.state()["a"]
	assert_eq(a, PackedFloat64Array([3, 4]))


func test_an_unknown_lesson_gets_one_notice_with_all_ids() -> void:
	await open_start_screen()
	await _request("no_such_lesson")
	assert_reads(
		"There is no lesson “no_such_lesson”. There are: %s." % ", ".join(LessonIndex.ids())
	)


func test_nothing_asked_for_shows_no_notice() -> void:
	await open_start_screen()
	await _request("")
	assert_does_not_read("There is no lesson")


func test_a_request_is_taken_once_so_that_the_way_back_leads_to_the_start_screen() -> void:
	LessonRequest.ask("dot_product")
	await open_start_screen()
	await student.settle()
	await student.press(&"lab_back")
	assert_null(frame())


func _request(id: String) -> void:
	screen().call(&"open_requested", id)
	await student.settle()
