class_name LessonIndex
extends RefCounted
## The lessons in the order of their numbers; that of the lecture is in [LessonAgenda]. A new lesson
## is one folder and one line here.

## Folders below `scenes/lessons/`; the two digits in front are the place in this list.
const FOLDERS: PackedStringArray = [
	"l01_class_or_value",
	"l02_easy_bounce",
	"l03_normals",
	"l04_dot_product",
	"l05_projection_proof",
	"l06_line_distance",
	"l07_point_of_impact",
	"l08_reflection",
	"l09_angled_lines",
	"l10_line_ends",
	"l11_more_dimensions",
	"l12_error_and_time",
	"l13_aim_at",
	"l14_lead_target",
	"l15_ballistic_aim",
	"l16_bank_shot",
	"l17_timed_shot",
	"l18_newton_balls",
	"l19_slide_and_roll",
	"l20_collision_friction",
	"l21_moving_platforms",
]

## What a lesson is, `%` its folder.
const LESSON_FILE := "res://scenes/lessons/%s/lesson.tres"
## What the game is, which is opened as a lesson is; `%` its folder.
const GAME_FILE := "res://scenes/%s/lesson.tres"
const _GAME_FOLDER := "game"


## All lessons in order, in a demo its only one; loads their cards' texts, not their scenes.
static func lessons() -> Array[LessonInfo]:
	var found: Array[LessonInfo] = []
	for folder in FOLDERS:
		if ResourceLoader.exists(LESSON_FILE % folder):
			found.append(load(LESSON_FILE % folder) as LessonInfo)
	return found


## The game; null in a demo of a lesson.
static func game() -> LessonInfo:
	var file := GAME_FILE % _GAME_FOLDER
	return load(file) as LessonInfo if ResourceLoader.exists(file) else null


## All that can be opened: the lessons in order, and behind them the game.
static func all() -> Array[LessonInfo]:
	var found := lessons()
	if game():
		found.append(game())
	return found


## The ids of all lessons in order.
static func ids() -> PackedStringArray:
	var found: PackedStringArray = []
	for lesson in lessons():
		found.append(lesson.id)
	return found


## The lesson with this id; null where there is none. A folder that has the id as its name is found
## without being in the list: a lesson that is just being written.
static func find(id: StringName) -> LessonInfo:
	for lesson in all():
		if lesson.id == id:
			return lesson
	if id.is_valid_ascii_identifier() and ResourceLoader.exists(LESSON_FILE % id):
		return load(LESSON_FILE % id) as LessonInfo
	return null


## One translated sentence for an id that no lesson has.
static func refusal(id: String) -> String:
	var sentence := TranslationServer.translate("There is no lesson “%s”. There are: %s.")
	return sentence % [LessonLink.quoted(id), ", ".join(ids())]


## The lesson's place in the order, from 1, in a demo too; 0 for one that is not in the index.
static func number_of(lesson: LessonInfo) -> int:
	return FOLDERS.find(lesson.resource_path.get_base_dir().get_file()) + 1


## The lesson's number and its title in the reader's language: `4  The dot product`. A lesson that
## is not in the index has no number.
static func heading_of(lesson: LessonInfo) -> String:
	var number := number_of(lesson)
	var title := LabText.translate(lesson.title)
	return "%d  %s" % [number, title] if number > 0 else title
