extends LabTest
## Controllers stay short, and say what is special in their lesson: plumbing goes into the services
## that own it.

const _LONGEST := 170
## The most lines of code in the smallest lesson, which is read first and has one script.
const _LONGEST_OF_SMALLEST := 40
## At most this share of the lines may stand in three lessons or more. What every lesson must have,
## and lines that hold only syntax, are left out of the count.
const _LARGEST_SHARE := 0.1
const _FEWEST := 3
const _NEEDED: PackedStringArray = [
	"extends Lesson", "func start() -> void:", "func _show() -> void:"
]
const _SYNTAX: PackedStringArray = [")", "]", "}", "else:", "return", "pass"]


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
		codes.append(_counted_lines(FileAccess.get_file_as_string(_controller(lesson))))
	var common := "\n".join(_common_lines(codes))
	assert_lte(_shared_share(codes), _LARGEST_SHARE, "in many controllers:\n%s" % common)


func test_shared_lines_are_found() -> void:
	var code := "extends Lesson\n\n# A comment.\nfunc start() -> void:\n\tbegin(\n\t)\n"
	var one := _counted_lines(code)
	assert_eq(one, PackedStringArray(["begin("]), "what every lesson must have is left out")
	var other: PackedStringArray = ["var a := 1", "var b := 2", "begin("]
	assert_eq(_shared_share([one, one, other]), 3.0 / 5.0)
	assert_eq(_shared_share([one, other]), 0.0, "in two controllers only")


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


func _counted_lines(code: String) -> PackedStringArray:
	var lines: PackedStringArray = []
	for line: String in _lines_of_code(code):
		if not line in _NEEDED and not line in _SYNTAX:
			lines.append(line)
	return lines


# The share of lines that stand in many of [param codes].
func _shared_share(codes: Array[PackedStringArray]) -> float:
	var common := _common_lines(codes)
	var total := 0
	var shared := 0
	for code: PackedStringArray in codes:
		total += code.size()
		for line: String in code:
			shared += 1 if line in common else 0
	return float(shared) / total


func _common_lines(codes: Array[PackedStringArray]) -> PackedStringArray:
	var found: PackedStringArray = []
	for code: PackedStringArray in codes:
		for line: String in code:
			var places := codes.filter(func(other: PackedStringArray) -> bool: return line in other)
			if places.size() >= _FEWEST and not line in found:
				found.append(line)
	return found
