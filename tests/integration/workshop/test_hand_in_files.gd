extends LabTest
## A student's files are found in whatever he hands in, and nothing else is read.

const HandInFiles := preload("res://tools/grading/hand_in_files.gd")

const _FOLDER := "user://hard_hand_ins"
const _MEGABYTES := 3


func before_all() -> void:
	var folder := ProjectSettings.globalize_path(_FOLDER)
	OS.execute("rm", ["-rf", folder])
	HardHandIns.new(folder).make_all(_MEGABYTES)


func after_all() -> void:
	OS.execute("rm", ["-rf", ProjectSettings.globalize_path(_FOLDER)])


func should_skip_script() -> bool:
	return not LabCommand.is_possible()


func test_right_ones_are_found_however_they_are_packed() -> void:
	for hand_in: String in [
		"Jos\u00e9 de la Cruz_12345_assignsubmission_file_",
		"Zip_12346_assignsubmission_file_",
		"zip_of_files.zip",
		"two_deep",
	]:
		_assert_is_right(_found(hand_in), hand_in)


func test_of_a_whole_lab_only_what_the_student_has_written_counts() -> void:
	var found := _found("zip_of_lab.zip")
	_assert_is_right(found, "neither a starter nor a hand-in of the lab's own tests")
	assert_false(found.files.has("my_bounce.gd"))


func test_tests_are_found_too() -> void:
	var names := _found("with_tests").files.keys()
	names.sort()
	assert_eq(names, ["my_vec2.gd", "test_my_vec2.gd"])


func test_what_is_missing_is_told_by_its_name() -> void:
	_assert_problem("nothing", "my_vec2.gd my_line.gd my_impact.gd my_bounce.gd")
	_assert_problem("other_language", "there is: Vec2.cs")
	_assert_problem("misnamed", "My_Vec2.gd is not looked at: its name must be my_vec2.gd")
	_assert_problem("misnamed_copy", "my_vec2 (1).gd is not looked at")
	_assert_problem("twice", "There is more than one my_vec2.gd: ")
	_assert_problem("many_tests", "more than 20 test files")
	_assert_problem("rar.rar", "neither a folder nor a .zip")


func test_a_hostile_zip_gives_nothing() -> void:
	_assert_problem("zip_climbs.zip", "there is: ../../climbed/my_vec2.gd")
	_assert_problem("zip_bomb_that_lies.zip", "damaged")
	assert_engine_error("err != 1", "The engine unpacks no more than was promised.")
	_assert_problem("zip_locked.zip", "locked by a password", 2)
	_assert_problem("zip_cut_off.zip", "no zip")
	_assert_problem("zip_of_noise.zip", "no zip")
	_assert_problem("zip_empty.zip", "no zip")


func test_no_more_of_a_file_is_read_than_the_judge_looks_at() -> void:
	for hand_in: String in ["zip_bomb.zip", "huge"]:
		var bytes := _found(hand_in).files["my_vec2.gd"]
		assert_eq(bytes.size(), WorkshopCode.LARGEST + 1, hand_in)


func test_no_link_is_followed_and_no_pipe_waited_for() -> void:
	_assert_problem("link_out", "my_vec2.gd is a link", 1)
	_assert_problem("link_to_folder", "It is a link")
	_assert_problem("pipe", "my_vec2.gd cannot be read", 1)
	var looped := _found("link_round")
	assert_eq(looped.files.keys(), ["my_vec2.gd"])
	assert_eq(looped.problems, PackedStringArray())


func _found(hand_in: String) -> HandInFiles:
	return HandInFiles.new(ProjectSettings.globalize_path(_FOLDER.path_join(hand_in)))


func _assert_is_right(found: HandInFiles, text: String) -> void:
	assert_eq(found.problems, PackedStringArray(), text)
	var wanted := HardHandIns.right_files("")
	assert_eq(found.files.size(), wanted.size(), text)
	for file in found.files:
		assert_eq(found.files[file], wanted[file], text)


func _assert_problem(hand_in: String, words: String, files: int = 0) -> void:
	var found := _found(hand_in)
	assert_string_contains(" ".join(found.problems), words)
	assert_eq(found.files.size(), files, hand_in)
