extends WorkshopTest
## The page with the rubric: what each line says, and what it opens.


func before_each() -> void:
	super.before_each()
	await judged()


func test_every_exercise_that_counts_for_a_mark_is_in_a_line_of_that_mark() -> void:
	var found: Dictionary[WorkshopReport.Mark, Array] = {}
	for line in Rubric.lines():
		if line.proof == RubricLine.Proof.EXERCISES:
			var listed: Array = found.get_or_add(line.mark, [])
			listed.append_array(Array(line.exercises))
	assert_eq(found[WorkshopReport.Mark.SUFFICIENT], Array(WorkshopReport.SUFFICIENT))
	assert_eq(found[WorkshopReport.Mark.GOOD], Array(WorkshopReport.GOOD))
	assert_eq(found[WorkshopReport.Mark.EXCELLENT], Array(WorkshopReport.EXCELLENT))


func test_every_lesson_of_a_line_is_there_and_is_that_of_its_exercises() -> void:
	for line in Rubric.lines():
		assert_true(line.lesson == "" or LessonIndex.find(line.lesson) != null, line.text)
		for exercise in line.exercises:
			assert_eq(WorkshopIndex.exercise(exercise).lesson, line.lesson, line.text)


func test_a_line_says_what_comes_next_and_then_that_it_is_reached() -> void:
	await _open_page()
	assert_reads("·  Vectors: the unit normal")
	assert_reads("Exercise 2, The normal: Write normal in my_vec2.gd.")
	write_first_two()
	look_again()
	await judged()
	assert_reads("✓  Vectors: the unit normal")
	assert_does_not_read("Exercise 2, The normal")
	assert_reads("Reached: not yet sufficient")


func test_a_mistake_is_told_by_its_sentence() -> void:
	write("dot", "return x * other.x - y * other.y")
	look_again()
	await judged()
	await _open_page()
	assert_reads("Exercise 3, The dot product: The two products are subtracted: add them.")


func test_in_another_language_all_is_said_anew() -> void:
	var before := TranslationServer.get_locale()
	write("dot", "return x * other.x - y * other.y")
	look_again()
	await judged()
	TranslationServer.set_locale("nl")
	var sentence := "Opgave 3, Het inproduct: Je trekt de twee producten af: tel ze op."
	await _open_page()
	await until(func() -> bool: return Screen.reads(screen(), sentence))
	assert_reads(sentence)
	TranslationServer.set_locale(before)


func test_with_all_right_every_line_that_is_judged_is_reached() -> void:
	var report := _report_with_all_right()
	assert_eq(report.mark(), WorkshopReport.Mark.EXCELLENT)
	for line in Rubric.lines():
		assert_ne(line.state(report), RubricLine.State.OPEN, line.text)


func test_each_mark_asks_for_its_lines() -> void:
	var report := _report_with_all_right()
	for line in Rubric.lines():
		if line.proof == RubricLine.Proof.EXERCISES:
			for exercise in line.exercises:
				report.verdict(exercise).kind = WorkshopVerdict.Kind.MISTAKE
				assert_eq(line.state(report), RubricLine.State.OPEN, line.text)
				assert_lt(report.mark(), line.mark, line.text)
				report.verdict(exercise).kind = WorkshopVerdict.Kind.RIGHT


func test_lines_about_tests_and_normals_are_open_without_them() -> void:
	var report := _report_with_all_right()
	report.verdict(9).is_excellent = false
	report.tests.missed = PackedStringArray(["dot: one"])
	for line in Rubric.lines():
		if line.proof in [RubricLine.Proof.EXCELLENT, RubricLine.Proof.ALL_TESTS]:
			assert_eq(line.state(report), RubricLine.State.OPEN, line.text)
		if line.proof == RubricLine.Proof.TESTS:
			assert_eq(line.state(report), RubricLine.State.REACHED, line.text)


func test_the_run_time_is_told_and_lowers_nothing() -> void:
	var report := _report_with_all_right()
	for ratio: float in [1.5, 900.0]:
		for verdict: WorkshopVerdict in report.verdicts.values():
			verdict.costs = PackedFloat64Array([10.0, 10.0 / ratio, ratio, 0.0])
		var line: RubricLine = Rubric.lines().filter(_is_about_run_time)[0]
		assert_string_contains(line.told(report), "takes %s times" % NumberText.short(ratio, 2))
		assert_eq(report.mark(), WorkshopReport.Mark.EXCELLENT)


func test_every_button_opens_its_lesson() -> void:
	for i: int in Rubric.lines().size():
		var line := Rubric.lines()[i]
		if line.lesson:
			await _open_page()
			await student.click(_rows()[i].get_node("%Open") as Button)
			assert_not_null(frame(), line.text)
			assert_eq(str(frame().lesson_info.id), line.lesson)
			screen().free()


func test_tab_and_the_gamepad_open_a_lesson() -> void:
	for open: Callable in [student.press_key.bind(KEY_ENTER), student.press_pad.bind(JOY_BUTTON_A)]:
		await _open_page()
		for tab: int in 2:
			await student.press_key(KEY_TAB)
		await open.call()
		assert_not_null(frame())
		screen().free()


func test_a_finger_opens_the_board_of_exercise_0_and_b_leads_back() -> void:
	await _open_page()
	await student.touch(
		Screen.button(screen(), "Exercise 0: rotate").get_global_rect().get_center()
	)
	assert_true(screen() is RotationRoom)
	await student.press_pad(JOY_BUTTON_B)
	assert_true(screen() is RubricPage)


func _open_page() -> void:
	WorkshopWays.open_rubric(get_tree())
	await student.settle()


func _rows() -> Array[RubricRow]:
	var found: Array[RubricRow] = []
	for node: Node in screen().find_children("*", "PanelContainer", true, false):
		if node is RubricRow:
			found.append(node as RubricRow)
	return found


func _is_about_run_time(line: RubricLine) -> bool:
	return line.proof == RubricLine.Proof.RUN_TIME


func _report_with_all_right() -> WorkshopReport:
	var report := WorkshopReport.new()
	report.leave_open()
	for verdict: WorkshopVerdict in report.verdicts.values():
		verdict.kind = WorkshopVerdict.Kind.RIGHT
		verdict.is_excellent = true
	report.tests = WorkshopTestsVerdict.new()
	report.tests.found = PackedStringArray(["a", "b", "c", "d"])
	report.tests.is_complete = true
	return report
