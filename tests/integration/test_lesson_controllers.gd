extends LabTest
## Controllers stay short, and say what is special in their lesson: plumbing goes into the services
## that own it.

const _LONGEST := 170
## At most this share of the lines of code may be found in as many controllers as this.
const _LARGEST_SHARE := 0.10
const _COMMON := 4


func test_no_controller_is_long() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		var code := FileAccess.get_file_as_string(_controller(lesson))
		assert_lte(code.count("\n"), _LONGEST, lesson.id)


func test_controllers_share_few_lines() -> void:
	var codes: Array[PackedStringArray] = []
	for lesson: LessonInfo in LessonIndex.lessons():
		codes.append(_lines_of_code(FileAccess.get_file_as_string(_controller(lesson))))
	assert_lte(_share_of_common_lines(codes), _LARGEST_SHARE)


func test_common_lines_are_found() -> void:
	var one := _lines_of_code("extends Lesson\n\n# A comment.\nfunc start() -> void:\n\tpass\n")
	assert_eq(one, PackedStringArray(["extends Lesson", "func start() -> void:", "pass"]))
	var other: PackedStringArray = ["extends Lesson", "var a := 1", "var b := 2", "var c := 3"]
	assert_eq(_share_of_common_lines([one, one, one, one]), 1.0)
	assert_eq(_share_of_common_lines([one, one, one, other]), 4.0 / 13.0)
	assert_eq(_share_of_common_lines([one, one, one]), 0.0)


func _controller(lesson: LessonInfo) -> String:
	return lesson.scene_path().get_basename() + ".gd"


# Without blank lines, comments and indentation.
func _lines_of_code(code: String) -> PackedStringArray:
	var lines: PackedStringArray = []
	for line: String in code.split("\n"):
		var bare := line.strip_edges()
		if bare and not bare.begins_with("#"):
			lines.append(bare)
	return lines


func _share_of_common_lines(codes: Array[PackedStringArray]) -> float:
	var places: Dictionary[String, int] = {}
	var total := 0
	for code: PackedStringArray in codes:
		total += code.size()
		var seen: Dictionary[String, bool] = {}
		for line: String in code:
			if not seen.has(line):
				seen[line] = true
				places[line] = places.get(line, 0) + 1
	var common := 0
	for code: PackedStringArray in codes:
		for line: String in code:
			common += 1 if places[line] >= _COMMON else 0
	return float(common) / total
