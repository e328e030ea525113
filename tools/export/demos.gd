extends RefCounted
## What can be exported: the whole lab, and each lesson, the game and the workshop as a demo of its
## own.

const NeededFiles := preload("needed_files.gd")

## The name of the whole lab beside the ids of the lessons.
const LAB := "lab"
## The name of the workshop, where the student writes his own code.
const WORKSHOP := "workshop"
## What a demo is told by: see `application/run/main_scene` in the project's settings.
const FEATURES: Dictionary[String, String] = {LAB: "", WORKSHOP: "workshop"}
const _FEATURE_OF_LESSONS := "demo"

# What the lab has besides lessons: it finds these by settings.
const _BESIDES: PackedStringArray = ["vec2_lab/lesson/besides", "vec2_lab/start_screen/besides"]


## The names of all demos: the lab, then the lessons in their order, the game, and the workshop.
static func names() -> PackedStringArray:
	var found: PackedStringArray = [LAB]
	for lesson in LessonIndex.all():
		found.append(lesson.id)
	found.append(WORKSHOP)
	return found


## The feature by which a demo knows what it is; "" for the lab.
static func feature_of(demo: String) -> String:
	return FEATURES.get(demo, _FEATURE_OF_LESSONS)


## What the demo with this name holds.
static func needed_by(demo: String) -> NeededFiles:
	return NeededFiles.new(_starts(demo))


## The files that the engine itself opens when the demo starts.
static func opened_by_engine(demo: String) -> PackedStringArray:
	var feature := feature_of(demo)
	var main_scene := "application/run/main_scene" + ("." + feature if feature else "")
	var opened: PackedStringArray = [_setting(main_scene), _setting("gui/theme/custom")]
	var translations: PackedStringArray = ProjectSettings.get_setting(
		"internationalization/locale/translations", PackedStringArray()
	)
	if demo == LAB:
		for setting in _BESIDES:
			opened.append(_setting(setting))
	return opened + translations


static func _starts(demo: String) -> PackedStringArray:
	var starts := opened_by_engine(demo)
	if demo == WORKSHOP:
		return starts
	if demo != LAB:
		starts.append(LessonIndex.find(demo).resource_path)
		return starts
	for lesson: LessonInfo in LessonIndex.all():
		starts.append(lesson.resource_path)
		starts.append(lesson.card_path())
	return starts


static func _setting(title: String) -> String:
	return ProjectSettings.get_setting(title)
