extends LabTest
## The lists of `./lab mutants` fit the code. The mutants themselves are run by that command only.

const MutantList := preload("res://tools/mutants/mutant_list.gd")
const Mutant := preload("res://tools/mutants/mutant.gd")
const Replacement := preload("res://tools/mutants/replacement.gd")
const SmallChanges := preload("res://tools/mutants/small_changes.gd")

## The first and the last number of those that can be made.
const FIRST_MISTAKE := 1
const LAST_MISTAKE := 24

var mutants := MutantList.new()


func test_every_entry_of_the_lists_fits_its_file_exactly_once() -> void:
	assert_eq(mutants.problems, PackedStringArray())


func test_every_mistake_of_the_course_is_made() -> void:
	var titles := PackedStringArray()
	for mutant: Mutant in mutants.named:
		titles.append(mutant.title)
	for number: int in range(FIRST_MISTAKE, LAST_MISTAKE + 1):
		assert_string_contains("\n".join(titles), "mistake %d: " % number)


func test_there_are_many_small_changes() -> void:
	assert_gt(mutants.others.size(), 300)


func test_a_replacement_must_fit_once() -> void:
	var replacement := Replacement.new("scripts/some.gd", "a title")
	replacement.old_text = "\tx = 1\n"
	replacement.new_text = "\tx = 2\n"
	assert_eq(replacement.problem("\ty = 1\n\tx = 1\n"), "")
	assert_string_contains(replacement.problem("\ty = 1\n"), "scripts/some.gd: a title: ")
	assert_string_contains(replacement.problem("\tx = 1\n\tx = 1\n"), "once")


func test_a_replacement_fits_whole_lines_only() -> void:
	var replacement := Replacement.new("scripts/some.gd", "a title")
	replacement.old_text = "x = 1\n"
	assert_ne(replacement.problem("\tx = 1\n"), "")


func test_a_replacement_changes_its_lines_and_nothing_else() -> void:
	var replacement := Replacement.new("scripts/some.gd", "a title")
	replacement.old_text = "b\nc\n"
	replacement.new_text = "d\n"
	var mutant := replacement.mutant("a\nb\nc\ne\n")
	assert_eq(mutant.code, "a\nd\ne\n")
	assert_eq(mutant.line, 2)


func test_each_operator_sign_and_number_is_changed_once() -> void:
	assert_eq(
		_changed_lines("\treturn -x * 0.5"),
		["\treturn -x / 0.5", "\treturn x * 0.5", "\treturn -x * (2.0 * 0.5)"]
	)


func test_comments_and_strings_are_not_changed() -> void:
	assert_eq(_changed_lines('\tprint("1 + 1")  # is 2 > 1'), [])


func test_an_exponent_is_no_sign_and_no_number_of_its_own() -> void:
	assert_eq(_changed_lines("const TINY := 1e-9"), ["const TINY := (2.0 * 1e-9)"])


func _changed_lines(line: String) -> Array[String]:
	var lines: Array[String] = []
	for mutant: Mutant in SmallChanges.of("scripts/some.gd", line):
		lines.append(mutant.code)
	return lines
