extends Node
## What the workshop adds to the start screen: a heading, a card that opens the next exercise, and
## one that opens the rubric. Where no child can be started, as in a browser, the exercises are
## written in the lab itself.

const _HEADING := preload("res://scenes/shell/lesson_heading.tscn")
const _CODE_CARD := preload("res://scenes/workshop/room/code_card.tscn")
const _RUBRIC_CARD := preload("res://scenes/workshop/room/rubric_card.tscn")
# What the keys do in a word: source text.
const _ACTIONS: Dictionary[StringName, String] = {&"lab_own_code": "own code"}

var _code: WorkshopCard
var _rubric: WorkshopCard


## Adds heading and cards to [param shelf], and returns the keys that it knows, with what each does.
func add_to(shelf: LessonShelf) -> Dictionary[StringName, String]:
	_add_heading(shelf)
	_code = _add_card(shelf, _CODE_CARD, WorkshopWays.open_next)
	if not WorkshopChild.can_run():
		_code.summarize(tr("Write the next method here, and see at once whether it is right."))
	_rubric = _add_card(shelf, _RUBRIC_CARD, WorkshopWays.open_rubric)
	var watcher := WorkshopLabWatcher.of(get_tree())
	watcher.judged.connect(_show_report)
	watcher.began.connect(_show_report.bind(null))
	_show_report(watcher.report)
	if WorkshopWays.take_way_back():
		_code.grab_focus.call_deferred()
	return _ACTIONS


func _unhandled_input(event: InputEvent) -> void:
	if event.is_action_pressed(&"lab_own_code", false, true):
		WorkshopWays.open_next(get_tree())


func _add_heading(shelf: LessonShelf) -> void:
	var heading := _HEADING.instantiate() as LessonHeading
	shelf.add_child(heading)
	var line := tr("The lecture's methods, written by you and looked at by the lab.")
	heading.show_part(LessonAgenda.Part.new(tr("The workshop"), line, []))


func _add_card(shelf: LessonShelf, scene: PackedScene, open: Callable) -> WorkshopCard:
	var card := scene.instantiate() as WorkshopCard
	shelf.add_child(card)
	card.pressed.connect(open.bind(get_tree()))
	return card


# Null while the student's files are looked at.
func _show_report(report: WorkshopReport) -> void:
	if not report or not report.is_complete:
		for card: WorkshopCard in [_code, _rubric]:
			card.show_progress(tr("Looking at your code"), false)
	else:
		var right := _count_right(report)
		var mark := report.mark()
		_code.show_progress(tr("%d of %d right") % [right, WorkshopIndex.LAST], right > 0)
		var reached := tr("Reached: %s") % WorkshopReport.name_of(mark)
		_rubric.show_progress(reached, mark != WorkshopReport.Mark.NOT_YET)
	(_code.get_parent() as LessonShelf).queue_sort()


# Without exercise 0, which is optional.
static func _count_right(report: WorkshopReport) -> int:
	var right := 0
	for exercise in range(1, WorkshopIndex.LAST + 1):
		right += int(report.is_right(exercise))
	return right
