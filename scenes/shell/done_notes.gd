class_name DoneNotes
extends RefCounted
## Notes what the student does in an open lesson, for the cards of the start screen. A demo of one
## lesson has no cards and does without it.


## From now on notes when the lesson in [param frame] has been seen, and its question answered.
static func follow(frame: LessonFrame) -> void:
	if not frame.lesson:
		return
	var id := frame.lesson_info.id
	var services := frame.lesson.services
	if services.has(&"steps"):
		var steps := services[&"steps"] as Steps
		var note_last := func(_step: int) -> void:
			if steps.is_at_end():
				LessonsDone.note(LessonsDone.SEEN, id)
		steps.step_changed.connect(note_last)
		note_last.call(steps.step)
	else:
		LessonsDone.note(LessonsDone.SEEN, id)
	if services.has(&"question"):
		(services[&"question"] as Question).answered.connect(
			func(is_right: bool) -> void:
				if is_right:
					LessonsDone.note(LessonsDone.ANSWERED, id)
		)
