extends LabTest
## `./lab report` writes its table, its text and its pictures, and refuses what it does not know.

const FOLDER := "res://build/report"


func should_skip_script() -> bool:
	return not LabCommand.is_possible()


func test_a_quick_report_writes_table_text_and_pictures() -> void:
	var lab := LabCommand.run("res://", ["report", "--quick", "--problems=1,3"])
	assert_eq(lab.exit_code, 0, lab.output)
	assert_string_contains(lab.output, "scalar_projection: ")
	for file: String in [
		"error_vs_time.csv", "report.md", "scalar_projection.svg", "angled_lines.svg"
	]:
		assert_true(FileAccess.file_exists(FOLDER.path_join(file)), file)
	_assert_table(FileAccess.get_file_as_string(FOLDER.path_join("error_vs_time.csv")))
	_assert_text(FileAccess.get_file_as_string(FOLDER.path_join("report.md")))


func test_it_compares_run_times_with_older_reports() -> void:
	var table := FOLDER.path_join("error_vs_time.csv")
	LabCommand.run("res://", ["report", "--quick", "--problems=1"])
	var old := ProjectSettings.globalize_path(table)
	var arguments: PackedStringArray = ["report", "--quick", "--problems=1", "--against", old]
	var lab := LabCommand.run("res://", arguments + PackedStringArray(["--also", old]))
	assert_eq(lab.exit_code, 0, lab.output)
	var text := FileAccess.get_file_as_string(FOLDER.path_join("report.md"))
	for said: String in [lab.output, text]:
		assert_string_contains(said, "## Against older reports\n\n1 older, 2 new.")
		assert_string_contains(said, "| scalar_projection | dot product, up to 100 px | ")
		assert_string_contains(said, "Median of now / then: the lab's own methods ")


func test_a_file_that_is_no_table_is_refused() -> void:
	for arguments: PackedStringArray in [["--against"], ["--also", "lab"], ["--against", "no.csv"]]:
		var lab := LabCommand.run("res://", PackedStringArray(["report"]) + arguments)
		assert_eq(lab.exit_code, 2)
		assert_string_contains(lab.output, "usage: ./lab report")
		assert_eq(lab.output.strip_edges().count("\n"), 0)


func test_what_it_does_not_know_is_refused_with_one_line() -> void:
	for argument: String in ["--fast", "quick", "--problems=12", "--problems=", "--problems=1;2"]:
		var lab := LabCommand.run("res://", ["report", argument])
		assert_eq(lab.exit_code, 2, argument)
		assert_string_contains(lab.output, "'%s'" % argument)
		assert_eq(lab.output.strip_edges().count("\n"), 0)


func test_every_problem_has_cases_of_its_own_in_both_forms() -> void:
	for problem in ReportProblems.all():
		for is_quick: bool in [true, false]:
			var cases := problem.cases(is_quick)
			assert_gt(cases.size(), 1, problem.id)
			for case in cases:
				assert_eq(
					[case.problem, case.is_baseline, case.method != ""], [problem.id, false, true]
				)


func test_no_two_cases_of_a_problem_are_named_alike() -> void:
	for problem in ReportProblems.all():
		var names: Dictionary[String, bool] = {}
		var cases := problem.cases(false) + problem.ceilings()
		cases.append_array(EngineCases.of(problem.id, false, self))
		cases.append_array(EngineAimCases.of(problem.id, false))
		for case in cases:
			names["%s, %s" % [case.method, case.setting]] = true
		assert_eq(names.size(), cases.size(), problem.id)


func _assert_table(text: String) -> void:
	var lines := text.strip_edges().split("\n")
	assert_eq(lines[0], MeasurementTable.COLUMNS)
	assert_gt(lines.size(), 20)
	for line in lines.slice(1):
		var cells := MeasurementTable.cells(line)
		assert_eq(cells.size(), 10, line)
		assert_true(cells[4].is_valid_float() and cells[4].to_float() >= 0.0, line)
		assert_true(cells[5] == "" or cells[5].is_valid_float(), line)
		assert_false(line.to_lower().contains("nan") or line.to_lower().contains(",inf"), line)


func _assert_text(text: String) -> void:
	assert_string_contains(text, "## The scalar projection of one vector on another")
	assert_string_contains(text, "## One ball among angled lines")
	assert_string_contains(text, "**400 px/s**: on the frontier ")
	assert_string_contains(text, "after 100 s, px | at most 1e-9 | not measured in this run | - |")
