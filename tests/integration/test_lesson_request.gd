extends ScreenTest
## Opening a lesson from the command line or a browser's address.


func test_the_command_line_names_a_lesson() -> void:
	assert_eq(LessonRequest.id_in_arguments(["--verbose", "--lesson=dot_product"]), "dot_product")


func test_a_command_line_without_a_lesson_asks_for_none() -> void:
	assert_eq(LessonRequest.id_in_arguments(["--verbose", "dot_product"]), "")
	assert_eq(LessonRequest.id_in_arguments([]), "")


func test_a_browsers_address_names_a_lesson() -> void:
	assert_eq(LessonRequest.id_in_fragment("#dot_product"), "dot_product")
	assert_eq(LessonRequest.id_in_fragment("#no%20lesson"), "no lesson")
	assert_eq(LessonRequest.id_in_fragment(""), "")


func test_the_lesson_asked_for_is_opened() -> void:
	await open_start_screen()
	await _request("dot_product")
	assert_eq(frame().lesson_info.id, &"dot_product")


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
	LessonRequest.take_id()
	assert_eq(LessonRequest.take_id(), "")


func _request(id: String) -> void:
	screen().call(&"open_requested", id)
	await student.settle()
