class_name RubricPage
extends WorkshopScreen
## The course's rubric, line by line: what the student has reached by his own code, and where the
## lab shows it.

## A lesson is to be opened.
signal lesson_wanted(lesson: LessonInfo)
## The board of exercise 0 is to be opened.
signal rotation_wanted

const _ROW := preload("res://scenes/workshop/room/rubric_row.tscn")

var _rows: Array[RubricRow] = []
# Rows and headings: all that says something in one language.
var _added: Array[Control] = []
var _watcher: WorkshopWatcher

@onready var _lines: VBoxContainer = %Lines
@onready var _reached: Label = %Reached
@onready var _rotation: Button = %Rotation


func _ready() -> void:
	super()
	_rotation.pressed.connect(rotation_wanted.emit)
	_add_lines()
	_show_report(null)
	_watcher = WorkshopLabWatcher.of(get_tree())
	_watcher.judged.connect(_show_report)
	_watcher.began.connect(_show_report.bind(null))
	_show_report(_watcher.report)


# His verdicts follow as soon as they have been said in that language.
func _say_again() -> void:
	super()
	for line in _added:
		line.queue_free()
	_added.clear()
	_rows.clear()
	_add_lines()
	_show_report(null)


func _add_lines() -> void:
	var mark := WorkshopReport.Mark.NOT_YET
	for line in Rubric.lines():
		if line.mark != mark:
			mark = line.mark
			_add_heading(mark)
		_add_row(line)


func _add_heading(mark: WorkshopReport.Mark) -> void:
	var heading := Label.new()
	heading.theme_type_variation = &"LabelTitle"
	heading.auto_translate_mode = AUTO_TRANSLATE_MODE_DISABLED
	heading.text = tr("For “%s”") % WorkshopReport.name_of(mark)
	heading.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	_lines.add_child(heading)
	_added.append(heading)


func _add_row(line: RubricLine) -> void:
	var row := _ROW.instantiate() as RubricRow
	_lines.add_child(row)
	_added.append(row)
	row.show_line(line)
	row.lesson_wanted.connect(lesson_wanted.emit)
	_rows.append(row)


# Null while the student's files are looked at: what is shown stays until then.
func _show_report(report: WorkshopReport) -> void:
	if not report or not report.is_complete:
		_reached.text = tr("Looking at your code")
		return
	_reached.text = tr("Reached: %s") % WorkshopReport.name_of(report.mark())
	for row in _rows:
		row.show_report(report)
