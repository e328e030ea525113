class_name RubricRow
extends PanelContainer
## A line of the rubric on the page: what is asked for, how far the student is, and a button for the
## lesson that shows it.

## The lesson that shows it is to be opened.
signal lesson_wanted(lesson: LessonInfo)

const _SIGNS: Dictionary[RubricLine.State, String] = {
	RubricLine.State.REACHED: "✓", RubricLine.State.OPEN: "·", RubricLine.State.NOT_JUDGED: "–"
}
const _ROLES: Dictionary[RubricLine.State, Palette.Role] = {
	RubricLine.State.REACHED: Palette.Role.RIGHT,
	RubricLine.State.OPEN: Palette.Role.INK,
	RubricLine.State.NOT_JUDGED: Palette.Role.QUIET,
}

var _line: RubricLine

@onready var _text: Label = %Text
@onready var _told: Label = %Told
@onready var _open: Button = %Open


## Shows [param line] for the first time.
func show_line(line: RubricLine) -> void:
	_line = line
	_text.text = line.text
	var lesson := LessonIndex.find(line.lesson)
	_open.visible = lesson != null
	if lesson:
		_open.text = tr("Lesson %d") % LessonIndex.number_of(lesson)
		_open.tooltip_text = LabText.translate(lesson.title)
		_open.accessibility_name = "%s, %s" % [_open.text, _open.tooltip_text]
		_open.pressed.connect(lesson_wanted.emit.bind(lesson))


## Shows how far the student is.
func show_report(report: WorkshopReport) -> void:
	var state := _line.state(report)
	_text.text = "%s  %s" % [_SIGNS[state], _line.text]
	_text.add_theme_color_override(&"font_color", Palette.color(_ROLES[state]))
	_told.text = _line.told(report)
