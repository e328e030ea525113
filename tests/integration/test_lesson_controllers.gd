extends LabTest
## Controllers stay short, and say what is special in their lesson: plumbing goes into the services
## that own it.

const _LONGEST := 170
## The most lines of code in the smallest lesson, which is read first and has one script.
const _LONGEST_OF_SMALLEST := 40
## At most this share of the lines of code may be found in as many controllers as this.
const _LARGEST_SHARE := 0.06
const _COMMON := 4


func test_no_controller_is_long() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		var code := FileAccess.get_file_as_string(_controller(lesson))
		assert_lte(code.count("\n"), _LONGEST, lesson.id)


func test_the_smallest_lesson_is_small() -> void:
	var folder := "res://scenes/lessons/smallest_lesson/"
	assert_eq(SourceCode.files_below(folder, ["gd"]).size(), 1)
	var code := FileAccess.get_file_as_string(folder + "smallest_lesson.gd")
	assert_lte(_lines_of_code(code).size(), _LONGEST_OF_SMALLEST)


func test_controllers_share_few_lines() -> void:
	var codes: Array[PackedStringArray] = []
	for lesson: LessonInfo in LessonIndex.lessons():
		codes.append(_lines_of_code(FileAccess.get_file_as_string(_controller(lesson))))
	var hint := "in %d controllers or more:\n%s" % [_COMMON, "\n".join(_common_lines(codes))]
	assert_lte(_share_of_common_lines(codes), _LARGEST_SHARE, hint)


func test_common_lines_are_found() -> void:
	var one := _lines_of_code("extends Lesson\n\n# A comment.\nfunc start() -> void:\n\tpass\n")
	assert_eq(one, PackedStringArray(["extends Lesson", "func start() -> void:", "pass"]))
	var other: PackedStringArray = ["extends Lesson", "pass", "var a := 1", "var b := 2"]
	assert_eq(_share_of_common_lines([one, one, one, one]), 1.0)
	assert_eq(_share_of_common_lines([one, one, one, other]), 4.0 / 6.0)
	assert_eq(_share_of_common_lines([one, one, one]), 0.0)


func _controller(lesson: LessonInfo) -> String:
	return lesson.scene_path().get_basename() + ".gd"


# The lines without blank ones, comments and indentation.
func _lines_of_code(code: String) -> PackedStringArray:
	var lines: PackedStringArray = []
	for line: String in code.split("\n"):
		var bare := line.strip_edges()
		if bare and not bare.begins_with("#"):
			lines.append(bare)
	return lines


func _share_of_common_lines(codes: Array[PackedStringArray]) -> float:
	var lines := _common_lines(codes)
	var total := 0
	var common := 0
	for code: PackedStringArray in codes:
		for line: String in code:
			total += 0 if _is_demanded(line) else 1
			common += 1 if line in lines else 0
	return float(common) / total


# Every lesson must begin like that, and what it overrides is named like that: no plumbing.
func _is_demanded(line: String) -> bool:
	return line == "extends Lesson" or line.begins_with("func ") or line == "else:"


func _common_lines(codes: Array[PackedStringArray]) -> PackedStringArray:
	var found: PackedStringArray = []
	for code: PackedStringArray in codes:
		for line: String in code:
			var places := codes.filter(func(other: PackedStringArray) -> bool: return line in other)
			if places.size() >= _COMMON and not line in found and not _is_demanded(line):
				found.append(line)
	return found
