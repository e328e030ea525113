extends LabTest
## `./lab check` grades a folder of hand-ins. What is hard about single ones is tried in
## test_hand_in_files.gd; all together: tests/support/make_class.gd.

const _FOLDER := "res://build/check_test"
const _CLASS := _FOLDER + "/class"
const _RESULTS := _FOLDER + "/results"
const _TEMPORARY := _FOLDER + "/tmp"
# As a check leaves its home when it is killed: no process has this number.
const _LEFT := _TEMPORARY + "/vec2_lab_check.999999999"
const _FROM_DATA: PackedStringArray = ["hostile_loop", "dot_minus", "copied_engine", "form_binary"]

var _first: LabCommand
var _outside: PackedStringArray


func should_skip_script() -> bool:
	return not LabCommand.is_possible()


func before_all() -> void:
	OS.execute("rm", ["-rf", ProjectSettings.globalize_path(_FOLDER)])
	var hard := HardHandIns.new(ProjectSettings.globalize_path(_CLASS))
	hard.zip("zip_of_files.zip", HardHandIns.right_files(""))
	hard.put("=1+1\n/My_Vec2.gd", HardHandIns.right())
	hard.make_copies()
	for hand_in in _FROM_DATA:
		var path := HandIns.FOLDER.path_join(hand_in).path_join("my_vec2.gd")
		hard.put(hand_in + "/my_vec2.gd", FileAccess.get_file_as_bytes(path))
	hard.put(
		"dot_minus/test_my_vec2.gd",
		FileAccess.get_file_as_bytes("res://tests/data/hand_in_tests/my_vec2_test.gd")
	)
	DirAccess.make_dir_recursive_absolute(_LEFT.path_join("0/hand_in"))
	_outside = _listed(_CLASS)
	_first = _check([])


func after_all() -> void:
	OS.execute("rm", ["-rf", ProjectSettings.globalize_path(_FOLDER)])


func test_each_hand_in_gets_a_line_and_a_row() -> void:
	assert_eq(_first.exit_code, 0, _first.output)
	assert_string_contains(_first.last_line(), "8 judged in ")
	assert_string_contains(_first.output, "=1+1?: not judged. My_Vec2.gd is not looked at")
	assert_eq(_rows().size(), 8)
	assert_eq(_field("zip_of_files.zip", "mark"), "sufficient")
	assert_eq(_field("zip_of_files.zip", "right"), "10")
	assert_eq(_field("'=1+1?", "mark"), "", "no spreadsheet computes a name")
	assert_string_starts_with(
		_field("dot_minus", "exercise 3"), "wrong: The two products are subtr"
	)
	assert_string_contains(_field("dot_minus", "exercise 3"), "(my_vec2.gd, line ")
	assert_string_contains(
		_field("dot_minus", "tests"), " of 52: Red on a right class: test_normal_"
	)
	assert_string_starts_with(_field("form_binary", "exercise 3"), "form: ")


func test_what_calls_an_endless_method_waits_for_it() -> void:
	assert_string_starts_with(_field("hostile_loop", "exercise 3"), "endless: dot ")
	assert_string_starts_with(
		_field("hostile_loop", "exercise 4"), "waits: scalar_projection uses dot"
	)
	assert_string_starts_with(_field("hostile_loop", "exercise 9"), "waits: reflect uses dot")


func test_what_is_refused_has_no_mark() -> void:
	assert_eq(_field("copied_engine", "mark"), "look by hand")


func test_copies_are_told() -> void:
	assert_eq(_field("copy_of_one", "same code as"), "copy_renamed")
	assert_eq(_field("copy_renamed", "same code as"), "copy_of_one")
	assert_string_contains(_first.output, "copy_of_one: same code as copy_renamed")


func test_the_class_has_a_summary() -> void:
	var text := FileAccess.get_file_as_string(_RESULTS.path_join("results.md"))
	assert_string_contains(text, "| zip\\_of\\_files.zip | sufficient | 10 | ✓ |")
	assert_string_contains(text, "8 hand-ins. ")
	assert_string_contains(text, "\n| 3 The dot product | 3 | 4 | 0 | 0 |\n")
	assert_string_contains(text, "\n| 5 Distance to a line | 1 | 0 | 6 | 0 |\n")
	assert_string_contains(text, "\n| 1 | 3 | wrong: The two products are subtracted")
	assert_string_contains(text, "- copied\\_engine: look by hand at 0, 1")


func test_nothing_of_it_is_left_elsewhere() -> void:
	assert_eq(_listed(_CLASS), _outside)
	assert_eq(DirAccess.get_directories_at(_TEMPORARY), PackedStringArray())
	assert_eq(DirAccess.get_directories_at(_FOLDER), PackedStringArray(["class", "results", "tmp"]))


func test_it_goes_on_where_it_was_stopped() -> void:
	var path := _RESULTS.path_join("results.csv")
	var before := _without_seconds(_rows())
	var text := FileAccess.get_file_as_string(path)
	# As a kill leaves it: in the middle of the last row.
	FileAccess.open(path, FileAccess.WRITE).store_string(text.left(-20))
	assert_string_contains(_check([]).last_line(), "1 judged in ")
	assert_eq(_without_seconds(_rows()), before)
	assert_string_contains(_check([]).last_line(), "0 judged in ")


func test_a_changed_hand_in_is_judged_again() -> void:
	var path := _CLASS.path_join("dot_minus/my_vec2.gd")
	var text := FileAccess.get_file_as_string(path)
	FileAccess.open(path, FileAccess.WRITE).store_buffer(HardHandIns.right())
	assert_string_contains(_check(["--at-least", "sufficient"]).last_line(), "1 judged in ")
	assert_eq(_field("dot_minus", "exercise 3"), "right")
	FileAccess.open(path, FileAccess.WRITE).store_string(text)


func test_a_mark_that_is_not_reached_gives_exit_code_1() -> void:
	assert_eq(_check(["--at-least", "sufficient"]).exit_code, 1)


func test_a_wrong_request_is_refused() -> void:
	for arguments: PackedStringArray in [
		[], ["/not/there"], ["docs", "--into"], ["docs", "--fast"]
	]:
		var lab := LabCommand.run("res://", PackedStringArray(["check"]) + arguments)
		assert_eq(lab.exit_code, 2)
		assert_string_contains(lab.last_line(), "usage: ./lab check FOLDER [--into FOLDER]")


func _check(options: PackedStringArray) -> LabCommand:
	var arguments: PackedStringArray = ["check", ProjectSettings.globalize_path(_CLASS)]
	arguments.append_array(["--into", ProjectSettings.globalize_path(_RESULTS)])
	var environment: PackedStringArray = ["TMPDIR=" + ProjectSettings.globalize_path(_TEMPORARY)]
	return LabCommand.run("res://", arguments + options, environment)


func _field(hand_in: String, head: String) -> String:
	var row := _rows()[hand_in]
	return row[head]


# The fields of each row by their heads, by the name of the hand-in.
func _rows() -> Dictionary[String, Dictionary]:
	var file := FileAccess.open(_RESULTS.path_join("results.csv"), FileAccess.READ)
	var heads := file.get_csv_line()
	var rows: Dictionary[String, Dictionary] = {}
	while not file.eof_reached():
		var fields := file.get_csv_line()
		if fields.size() == heads.size():
			var row: Dictionary[String, String] = {}
			for index in heads.size():
				row[heads[index]] = fields[index]
			rows[fields[0]] = row
	return rows


func _without_seconds(rows: Dictionary[String, Dictionary]) -> Dictionary[String, Dictionary]:
	for row: Dictionary in rows.values():
		row.erase("seconds")
	return rows


# The files in a folder and below it, with their sums.
func _listed(folder: String) -> PackedStringArray:
	var said := []
	var script := "cd '%s' && find . -type f -exec md5sum {} + | sort"
	OS.execute("sh", ["-c", script % ProjectSettings.globalize_path(folder)], said)
	var text: String = said[0]
	return text.split("\n")
