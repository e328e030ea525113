class_name LessonWays
extends Node
## The ways from the open lesson to the ones before and behind it in the order of the
## [LessonAgenda]: a button and a key for each, and one step more than the lesson has, as a
## presenter's remote control sends it. Where the top bar has no room for the buttons, the steps
## lead on alone. In a demo there are none.

## Another lesson is to be opened.
signal wanted(lesson: LessonInfo)

## Keys, with what each does in a word for the help line: source text.
const ACTIONS: Dictionary[StringName, String] = {
	&"lab_previous_lesson": "lesson before", &"lab_next_lesson": "next lesson"
}

# In a window of less width the title would have no room beside them.
const _NARROWEST := 360.0

# Null where there is none.
var _before: LessonInfo
var _behind: LessonInfo

@onready var _previous: Button = %PreviousLesson
@onready var _next: Button = %NextLesson
@onready var _frame := owner as Control


func _ready() -> void:
	_previous.pressed.connect(_go.bind(-1))
	_next.pressed.connect(_go.bind(1))


## Offers the ways from the lesson [param here] among [param lessons]. The steps of [param lesson],
## null if it could not be opened, lead there, too.
func offer(here: LessonInfo, lessons: Array[LessonInfo], lesson: Lesson) -> void:
	var place := lessons.find(here)
	if place < 0:
		return
	_before = lessons[place - 1] if place > 0 else null
	_behind = lessons[place + 1] if place < lessons.size() - 1 else null
	var words_before := _prepare(_previous, _before, tr("Back to lesson %s"))
	var words_behind := _prepare(_next, _behind, tr("On to lesson %s"))
	_frame.resized.connect(_fit)
	_fit()
	if lesson and lesson.services.has(&"steps"):
		var steps := lesson.services[&"steps"]
		steps.call(&"lead_on", words_before, words_behind)
		steps.connect(&"led_on", _step_out)


func _unhandled_input(event: InputEvent) -> void:
	if event.is_action_pressed(&"lab_previous_lesson", false, true):
		_go(-1)
	elif event.is_action_pressed(&"lab_next_lesson", false, true):
		_go(1)


# Where there is room, both buttons are seen in every lesson, so that they keep their places.
func _fit() -> void:
	for button: Button in [_previous, _next]:
		button.visible = _frame.size.x >= _NARROWEST


func _prepare(button: Button, lesson: LessonInfo, sentence: String) -> String:
	button.disabled = lesson == null
	var words := sentence % LessonIndex.heading_of(lesson) if lesson else ""
	if lesson:
		button.tooltip_text = words
		button.accessibility_name = words
	return words


# On to the first step of the next lesson; back to where the one before was left, else to its end.
func _step_out(way: int) -> void:
	if way > 0:
		LessonBoards.keep_step(_behind.id, 0)
	elif not LessonBoards.has(_before.id):
		LessonBoards.keep_step(_before.id, LessonBoards.LAST_STEP)
	_go(way)


func _go(way: int) -> void:
	var lesson := _behind if way > 0 else _before
	if lesson:
		wanted.emit(lesson)
