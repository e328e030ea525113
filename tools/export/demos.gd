extends RefCounted
## What can be exported: the whole lab, and each lesson and the game as a demo of its own.

const NeededFiles := preload("needed_files.gd")

## The name of the whole lab beside the ids of the lessons.
const LAB := "lab"


## The names of all demos: the lab, then the lessons in their order, then the game.
static func names() -> PackedStringArray:
	var found: PackedStringArray = [LAB]
	for lesson in LessonIndex.all():
		found.append(lesson.id)
	return found


## What the demo with this name holds.
static func needed_by(demo: String) -> NeededFiles:
	return NeededFiles.new(_starts(demo))


## The files that the engine itself opens when the demo starts.
static func opened_by_engine(demo: String) -> PackedStringArray:
	var main_scene := "application/run/main_scene" + ("" if demo == LAB else ".demo")
	var opened: PackedStringArray = [_setting(main_scene), _setting("gui/theme/custom")]
	var translations: PackedStringArray = ProjectSettings.get_setting(
		"internationalization/locale/translations", PackedStringArray()
	)
	return opened + translations


static func _starts(demo: String) -> PackedStringArray:
	var starts := opened_by_engine(demo)
	if demo != LAB:
		starts.append(LessonIndex.find(demo).resource_path)
		return starts
	for lesson: LessonInfo in LessonIndex.all():
		starts.append(lesson.resource_path)
		starts.append(lesson.card_path())
	return starts


static func _setting(title: String) -> String:
	return ProjectSettings.get_setting(title)
