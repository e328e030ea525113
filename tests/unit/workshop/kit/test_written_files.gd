extends LabTest
## What a student writes in the lab itself, a text for each exercise, becomes files as he would have
## them on his disk; and each line of a file leads back to its text.

const _DOT := "func dot(other: MyVec2) -> float:\n\treturn x * other.x + y * other.y\n"


func after_each() -> void:
	for exercise in WorkshopKeptCode.exercises():
		WorkshopKeptCode.keep(exercise, WorkshopKeptCode.stub_of(exercise))
	super.after_each()


func test_without_a_text_the_files_are_the_starters() -> void:
	var files := WorkshopWrittenFiles.new([]).files
	assert_eq(files.keys(), WorkshopFiles.CLASSES.keys())
	for file in files:
		assert_eq(files[file].get_string_from_utf8(), WorkshopFiles.starter(file), file)


func test_every_stub_holds_the_methods_of_its_exercise_and_no_others() -> void:
	for exercise in WorkshopKeptCode.exercises():
		var code := WorkshopCode.new(WorkshopKeptCode.stub_of(exercise).to_utf8_buffer())
		var methods := exercise.tasks.map(func(task: WorkshopTask) -> String: return task.method)
		assert_eq(Array(code.functions()), methods)
		assert_true(code.text.begins_with("## Exercise %d" % exercise.number), code.text)


func test_stubs_put_together_are_judged_as_the_starters_are() -> void:
	for exercise in WorkshopKeptCode.exercises():
		WorkshopKeptCode.keep(exercise, "\n" + WorkshopKeptCode.stub_of(exercise))
	var judge := WorkshopJudge.new(WorkshopHeardErrors.new(), WorkshopWatchdog.new(), [], true)
	judge.judge(WorkshopWrittenFiles.new([]).files, [])
	for exercise in WorkshopKeptCode.exercises():
		var verdict := judge.report.verdict(exercise.number)
		assert_eq(verdict.kind, WorkshopVerdict.Kind.OPEN, exercise.title)


func test_a_text_takes_the_place_of_its_methods_and_its_lines_are_known() -> void:
	var exercise := WorkshopIndex.exercise(3)
	WorkshopKeptCode.keep(exercise, _DOT)
	var written := WorkshopWrittenFiles.new([])
	var lines := written.files["my_vec2.gd"].get_string_from_utf8().split("\n")
	var line := lines.find(_DOT.split("\n")[1]) + 1
	assert_gt(line, 0)
	assert_eq(written.exercise_at("my_vec2.gd", line), 3)
	assert_eq(written.line_in_text(3, "my_vec2.gd", line), 2)
	assert_eq(written.line_in_text(2, "my_vec2.gd", line), 0)
	assert_eq(written.exercise_at("my_vec2.gd", 1), -1)
	assert_eq(written.exercise_at("my_line.gd", line), -1)
	assert_eq("\n".join(lines).count("func dot("), 1)
	assert_false(WorkshopWrittenFiles.new([3]).files == written.files)


func test_a_method_under_another_name_is_missing_and_not_open() -> void:
	WorkshopKeptCode.keep(WorkshopIndex.exercise(3), _DOT.replace("dot", "Dot"))
	var judge := WorkshopJudge.new(WorkshopHeardErrors.new(), WorkshopWatchdog.new(), [], true)
	judge.judge(WorkshopWrittenFiles.new([]).files, [])
	assert_string_contains(judge.report.verdict(3).sentence, "do you mean that by Dot?")


func test_spaces_are_no_mistake_and_mixed_ones_stay() -> void:
	var exercise := WorkshopIndex.exercise(3)
	WorkshopKeptCode.keep(exercise, _DOT.replace("\t", "    "))
	var text := WorkshopWrittenFiles.new([]).files["my_vec2.gd"].get_string_from_utf8()
	assert_string_contains(text, _DOT)
	WorkshopKeptCode.keep(exercise, _DOT.replace("return", "pass\n    return"))
	text = WorkshopWrittenFiles.new([]).files["my_vec2.gd"].get_string_from_utf8()
	assert_gt(WorkshopSentences.line_with_mixed_indent(text), 0)


func test_a_text_is_kept_and_its_stub_is_not() -> void:
	var exercise := WorkshopIndex.exercise(3)
	assert_false(WorkshopKeptCode.is_written(exercise))
	WorkshopKeptCode.keep(exercise, _DOT)
	KeptChoices.read_again()
	assert_eq(WorkshopKeptCode.text_of(exercise), _DOT)
	assert_true(WorkshopKeptCode.is_written(exercise))
	WorkshopKeptCode.keep(exercise, WorkshopKeptCode.stub_of(exercise))
	assert_false(WorkshopKeptCode.is_written(exercise))
