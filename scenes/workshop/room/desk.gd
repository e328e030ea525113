class_name WorkshopDesk
extends RefCounted
## Shows in an open lesson what the lab says of the student's own code, in the panel and on the
## board. A demo of one lesson does without it.

const _SECTION := "res://scenes/workshop/own_code.tscn"


## From now on the lesson in [param frame], a lesson frame that is ready, shows the student's
## answers to the exercises that belong to it.
static func follow(frame: Control) -> void:
	var lesson: Lesson = frame.get(&"lesson")
	if not lesson:
		return
	var info: LessonInfo = frame.get(&"lesson_info")
	var exercises := WorkshopIndex.of_lesson(info.id)
	if exercises.is_empty():
		return
	var watcher := WorkshopLabWatcher.of(frame.get_tree())
	var section := _add_section(frame, lesson, watcher, exercises)
	section.write_wanted.connect(WorkshopWays.open_code_of.bind(info, frame.get_tree()))
	_add_drawing(lesson, info.id, watcher)


static func _add_section(
	frame: Control,
	lesson: Lesson,
	watcher: WorkshopWatcher,
	exercises: Array[WorkshopExercise],
) -> OwnCode:
	var section := (load(_SECTION) as PackedScene).instantiate() as OwnCode
	frame.call(&"take_in", section)
	section.follow(lesson, watcher, exercises)
	var question := lesson.services[&"question"]
	question.get_parent().move_child(section, question.get_index())
	return section


static func _add_drawing(lesson: Lesson, id: String, watcher: WorkshopWatcher) -> void:
	var picture := OwnPictures.of_lesson(id)
	if picture:
		var board := lesson.get_node(picture.board_path)
		board.add_child(OwnAnswer.new(lesson, picture, watcher))
	elif id == "angled_lines":
		lesson.board.add_child(OwnFlight.new(lesson, watcher))
