extends LabTest
## The headings of the start screen against the index of lessons.

## The numbers of the lessons; the game has none.
const _ORDER: PackedInt32Array = [
	1, 2, 3, 4, 6, 7, 8, 9, 10, 11, 13, 14, 15, 16, 17, 0, 18, 20, 19, 21, 5, 12
]


func test_every_lesson_stands_below_one_heading() -> void:
	var found: Array[LessonInfo] = []
	for part: LessonAgenda.Part in LessonAgenda.parts():
		assert_ne(part.title, "")
		assert_ne(part.line, "", part.title)
		assert_gt(part.lessons.size(), 0, part.title)
		found.append_array(part.lessons)
	assert_eq(found.size(), LessonIndex.all().size())
	for lesson: LessonInfo in LessonIndex.all():
		assert_has(found, lesson)


func test_the_order_is_that_of_the_lecture_with_the_proof_behind() -> void:
	var numbers: PackedInt32Array = []
	for part: LessonAgenda.Part in LessonAgenda.parts():
		for lesson: LessonInfo in part.lessons:
			numbers.append(LessonIndex.number_of(lesson))
	assert_eq(numbers, _ORDER)
