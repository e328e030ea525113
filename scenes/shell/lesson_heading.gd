class_name LessonHeading
extends Control
## A heading above cards on the start screen, and one line that says what they are about.

@onready var _title: Label = $Title
@onready var _line: Label = $Line


## Shows the heading of [param part].
func show_part(part: LessonAgenda.Part) -> void:
	_title.text = part.title
	_line.text = part.line


## Lays the texts out for this width, and returns the height that they need.
func lay(width: float) -> float:
	var height := ShelfCard.lay_text(_title, Vector2.ZERO, width)
	return height + ShelfCard.lay_text(_line, Vector2(0.0, height), width)
