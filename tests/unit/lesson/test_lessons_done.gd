extends LabTest
## What has been done in the lessons is kept, and can be forgotten.


func before_each() -> void:
	KeptChoices.file = "user://choices_in_tests_%d.cfg" % OS.get_process_id()
	DirAccess.remove_absolute(KeptChoices.file)
	KeptChoices.read_again()


func after_each() -> void:
	DirAccess.remove_absolute(KeptChoices.file)
	KeptChoices.read_again()


func test_nothing_has_been_done_at_first() -> void:
	assert_false(LessonsDone.is_any())
	assert_false(LessonsDone.has(LessonsDone.SEEN, &"normals"))


func test_what_was_done_is_there_the_next_time() -> void:
	LessonsDone.note(LessonsDone.SEEN, &"normals")
	LessonsDone.note(LessonsDone.SEEN, &"reflection")
	LessonsDone.note(LessonsDone.ANSWERED, &"reflection")
	KeptChoices.read_again()
	assert_true(LessonsDone.is_any())
	assert_true(LessonsDone.has(LessonsDone.SEEN, &"normals"))
	assert_false(LessonsDone.has(LessonsDone.ANSWERED, &"normals"))
	assert_true(LessonsDone.has(LessonsDone.ANSWERED, &"reflection"))


func test_it_is_kept_once() -> void:
	for time: int in 3:
		LessonsDone.note(LessonsDone.SEEN, &"normals")
	var kept: PackedStringArray = KeptChoices.value(LessonsDone.SEEN, PackedStringArray())
	assert_eq(kept, PackedStringArray(["normals"]))


func test_what_is_forgotten_stays_forgotten_and_other_choices_stay() -> void:
	KeptChoices.keep("language", "nl")
	LessonsDone.note(LessonsDone.SEEN, &"normals")
	LessonsDone.note(LessonsDone.ANSWERED, &"reflection")
	LessonsDone.forget()
	KeptChoices.read_again()
	assert_false(LessonsDone.is_any())
	var language: String = KeptChoices.value("language", "")
	assert_eq(language, "nl")


func test_a_file_that_somebody_has_changed_counts_as_nothing_done() -> void:
	KeptChoices.keep(LessonsDone.SEEN, 7)
	assert_false(LessonsDone.has(LessonsDone.SEEN, &"normals"))
	LessonsDone.note(LessonsDone.SEEN, &"normals")
	assert_true(LessonsDone.has(LessonsDone.SEEN, &"normals"))
