extends LabTest
## What is said of the student's code: signs, answers, the worth of his tests, his mark.


func test_each_kind_of_verdict_has_a_sign_of_its_kind() -> void:
	for kind: WorkshopVerdict.Kind in WorkshopVerdict.Kind.values():
		var verdict := WorkshopVerdict.new()
		verdict.kind = kind
		var is_right := kind == WorkshopVerdict.Kind.RIGHT
		assert_eq(OwnCodeTexts.sign_of(verdict) == "✓", is_right)
		assert_eq(OwnCodeTexts.role_of(verdict) == Palette.Role.RIGHT, is_right)


func test_the_place_has_line_and_mistake_where_there_are_any() -> void:
	var verdict := WorkshopVerdict.new()
	verdict.file = "my_vec2.gd"
	assert_eq(OwnCodeTexts.place(verdict), "workshop / my_vec2.gd")
	verdict.line = 12
	verdict.mistake = 9
	assert_eq(OwnCodeTexts.place(verdict), "workshop / my_vec2.gd, line 12, mistake 9")
	verdict.mistake = -2
	assert_eq(OwnCodeTexts.place(verdict), "workshop / my_vec2.gd, line 12")


func test_an_answer_reads_as_its_kind() -> void:
	var touching := WorkshopIndex.task("is_touching")
	assert_eq(OwnCodeTexts.answer(touching, PackedFloat64Array([1.0])), "true")
	assert_eq(OwnCodeTexts.answer(touching, PackedFloat64Array([0.0])), "false")
	assert_eq(OwnCodeTexts.answer(touching, PackedFloat64Array()), "nothing")
	var time := WorkshopIndex.task("time_of_impact")
	assert_eq(OwnCodeTexts.answer(time, PackedFloat64Array([INF])), "∞")
	var normal := WorkshopIndex.task("normal")
	assert_eq(OwnCodeTexts.answer(normal, PackedFloat64Array([4.0, -3.0])), "(4, −3)")


func test_at_most_three_of_the_missed_are_named() -> void:
	var tests := WorkshopTestsVerdict.new()
	tests.found = ["dot: a"]
	tests.missed = ["rotate: a", "rotate: b", "normal: a"]
	var told := "Your tests find 1 of 4 mistakes."
	assert_eq(OwnCodeTexts.tests(tests), told + " Still green: rotate, normal.")
	tests.missed.append_array(["dot: b", "reflect: a"])
	assert_string_ends_with(OwnCodeTexts.tests(tests), "Still green: rotate, normal, dot, ….")
	tests.missed.clear()
	assert_eq(OwnCodeTexts.tests(tests), "Your tests find 1 of 1 mistakes.")
	assert_eq(OwnCodeTexts.tests(null), "")


func test_what_is_red_on_right_classes_comes_first() -> void:
	var tests := WorkshopTestsVerdict.new()
	tests.red_on_right = ["test_dot: expected 51"]
	tests.missed = ["rotate: a"]
	assert_eq(OwnCodeTexts.tests(tests), "Red on a right class: test_dot: expected 51")


func test_the_mark_says_what_the_next_one_asks_for() -> void:
	var report := _report_with([2])
	assert_eq(
		OwnCodeTexts.mark(report),
		"Mark: not yet sufficient. For sufficient: exercise 3, exercise 9."
	)
	report = _report_with([2, 3, 9, 4, 5, 6, 7])
	var tests := "tests that find 80 % of the mistakes"
	assert_eq(
		OwnCodeTexts.mark(report),
		"Mark: sufficient. For good: exercise 8, exercise 10, %s." % tests
	)


func test_the_way_from_good_to_excellent() -> void:
	var report := _report_with([2, 3, 4, 5, 6, 7, 8, 9, 10])
	report.tests = WorkshopTestsVerdict.new()
	report.tests.found = ["a: a", "a: b", "a: c", "a: d"]
	report.tests.missed = ["a: e"]
	var missing := "exercise 11, exercise 13, exercise 14, exercise 15"
	missing += ", tests that find all mistakes, exercise 9 with any normal"
	assert_eq(OwnCodeTexts.mark(report), "Mark: good. For excellent: %s." % missing)
	report.tests.missed.clear()
	report.verdicts[9].is_excellent = true
	for exercise: int in [11, 13, 14, 15]:
		report.verdicts[exercise].kind = WorkshopVerdict.Kind.RIGHT
	assert_eq(OwnCodeTexts.mark(report), "Mark: excellent.")


# A complete report in which these exercises are right.
func _report_with(right: PackedInt32Array) -> WorkshopReport:
	var report := WorkshopReport.new()
	report.leave_open()
	for exercise in right:
		report.verdicts[exercise].kind = WorkshopVerdict.Kind.RIGHT
	return report
