class_name WorkshopRoom
extends WorkshopScreen
## The entrance of the workshop: waits until the student's files have been judged, and leads to the
## lesson of the first exercise that is not solved yet. Where none is left, or the exercise has no
## lesson, it leads to the rubric.

## A lesson is to be opened.
signal lesson_wanted(lesson: LessonInfo)
## The rubric is to be opened.
signal rubric_wanted

var _is_through := false

@onready var _said: Label = %Said


func _ready() -> void:
	super()
	_say()
	var watcher := WorkshopLabWatcher.of(get_tree())
	watcher.judged.connect(_lead_on)
	if watcher.report:
		_lead_on(watcher.report)


func _say_again() -> void:
	super()
	_say()


func _say() -> void:
	_said.text = tr("Looking at your code")


func _lead_on(report: WorkshopReport) -> void:
	if _is_through or not report.is_complete:
		return
	_is_through = true
	var next := mini(report.first_open(), WorkshopIndex.LAST)
	var lesson := LessonIndex.find(WorkshopIndex.exercise(next).lesson)
	if lesson:
		lesson_wanted.emit(lesson)
	else:
		rubric_wanted.emit()
