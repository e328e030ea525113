extends LabTest
## The workflow for GitHub Classroom does what it says: its commands run here in folders like those
## on GitHub. What GitHub's own actions do is not known here.

const _WORKFLOW := "res://.github/classroom/autograding.yml"
const _FOLDER := "res://build/classroom_test"

var _text := ""
var _folder := ""


func should_skip_script() -> bool:
	return not LabCommand.is_possible()


func before_all() -> void:
	_text = FileAccess.get_file_as_string(_WORKFLOW)
	_folder = ProjectSettings.globalize_path(_FOLDER)
	OS.execute("rm", ["-rf", _folder])
	HardHandIns.new(_folder.path_join("hand_ins")).put_right("student")
	DirAccess.open(_folder).create_link(ProjectSettings.globalize_path("res://"), "lab")


func after_all() -> void:
	OS.execute("rm", ["-rf", _folder])


func test_its_commands_grade_a_student() -> void:
	var commands := _found("- run: (.*)")
	assert_eq(commands.size(), 3)
	for command in commands:
		var ran := _run(command)
		assert_eq(ran.exit_code, 0, "%s: %s" % [command, ran.output])
	var summary := FileAccess.get_file_as_string(_FOLDER.path_join("summary.md"))
	assert_string_contains(summary, "| student | sufficient | 10 |")
	var graded := _found("\n *command: (.*)")
	assert_eq(graded.size(), 3)
	for index in graded.size():
		var ran := _run(graded[index])
		assert_eq(ran.exit_code, 0 if index == 0 else 1, graded[index])
		assert_string_contains(ran.output, "0 judged in ", "nothing is judged twice")


func test_each_grader_is_reported() -> void:
	var ids := _found("- id: (\\w+)")
	assert_eq(_found("runners: (.*)"), PackedStringArray([",".join(ids)]))
	for id in ids:
		var line := "%s_RESULTS: ${{ steps.%s.outputs.result }}" % [id.to_upper(), id]
		assert_string_contains(_text, line)


func test_it_says_that_it_was_not_tried_and_names_versions() -> void:
	assert_string_contains(_text, "Not tried on GitHub itself")
	for action in _found("\n *(?:- )?uses: (.*)"):
		assert_true(
			RegEx.create_from_string("^[\\w-]+/[\\w-]+@v\\d+$").search(action) != null, action
		)


func _run(command: String) -> LabCommand:
	# On its way to the shell a quotation mark would be lost.
	var script := _folder.path_join("command.sh")
	FileAccess.open(script, FileAccess.WRITE).store_string("cd '%s'\n%s\n" % [_folder, command])
	var summary := "GITHUB_STEP_SUMMARY=" + _folder.path_join("summary.md")
	return LabCommand.run_words(["bash", "-e", script], [summary])


func _found(pattern: String) -> PackedStringArray:
	var found: PackedStringArray = []
	for hit in RegEx.create_from_string(pattern).search_all(_text):
		found.append(hit.get_string(1))
	return found
