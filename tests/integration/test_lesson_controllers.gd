extends LabTest
## Controllers stay short, and say what is special in their lesson: plumbing goes into the services
## that own it.

const _LONGEST := 170
## The most lines of code in the smallest lesson, which is read first and has one script.
const _LONGEST_OF_SMALLEST := 40
## At most this share of the lines may be copies. A line is a copy when it and the line before or
## after it are found together in this many controllers. One line alone, such as
## `on_pick(_model.take)`, is only a call of what all lessons share.
const _LARGEST_SHARE := 0.03
const _COMMON := 3


func test_no_controller_is_long() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		var code := FileAccess.get_file_as_string(_controller(lesson))
		assert_lte(code.count("\n"), _LONGEST, lesson.id)


func test_the_smallest_lesson_is_small() -> void:
	var folder := "res://scenes/lessons/smallest_lesson/"
	assert_eq(SourceCode.files_below(folder, ["gd"]).size(), 1)
	var code := FileAccess.get_file_as_string(folder + "smallest_lesson.gd")
	assert_lte(_lines_of_code(code).size(), _LONGEST_OF_SMALLEST)


func test_controllers_copy_few_lines() -> void:
	var codes: Array[PackedStringArray] = []
	for lesson: LessonInfo in LessonIndex.lessons():
		codes.append(_lines_of_code(FileAccess.get_file_as_string(_controller(lesson))))
	var pairs := "\n\n".join(_common_pairs(codes))
	assert_lte(_copied_share(codes), _LARGEST_SHARE, "in many controllers:\n%s" % pairs)


func test_copied_lines_are_found() -> void:
	var one := _lines_of_code("extends Lesson\n\n# A comment.\nfunc start() -> void:\n\tpass\n")
	assert_eq(one, PackedStringArray(["extends Lesson", "func start() -> void:", "pass"]))
	var other: PackedStringArray = ["extends Lesson", "var a := 1", "func start() -> void:", "pass"]
	assert_eq(_copied_share([one, one, one]), 1.0)
	assert_eq(_copied_share([one, one, other]), 6.0 / 10.0, "only the last two lines are neighbors")
	assert_eq(_copied_share([one, one]), 0.0, "in two controllers only")


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


# The share of lines that are in a pair that many controllers have.
func _copied_share(codes: Array[PackedStringArray]) -> float:
	var common := _common_pairs(codes)
	var total := 0
	var copied := 0
	for code: PackedStringArray in codes:
		var pairs := _pairs(code)
		total += code.size()
		for i: int in code.size():
			var is_first := i < pairs.size() and pairs[i] in common
			var is_second := i > 0 and pairs[i - 1] in common
			copied += 1 if is_first or is_second else 0
	return float(copied) / total


func _common_pairs(codes: Array[PackedStringArray]) -> PackedStringArray:
	var found: PackedStringArray = []
	for code: PackedStringArray in codes:
		for pair: String in _pairs(code):
			var places := codes.filter(
				func(other: PackedStringArray) -> bool: return pair in _pairs(other)
			)
			if places.size() >= _COMMON and not pair in found:
				found.append(pair)
	return found


# Each line with the one after it.
func _pairs(code: PackedStringArray) -> PackedStringArray:
	var pairs: PackedStringArray = []
	for i: int in code.size() - 1:
		pairs.append(code[i] + "\n" + code[i + 1])
	return pairs
