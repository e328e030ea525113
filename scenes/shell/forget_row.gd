class_name ForgetRow
extends HFlowContainer
## A button that forgets what has been done in the lessons. It asks once before.

## What had been done is forgotten.
signal forgotten

@onready var _wish: Button = %Wish
@onready var _question: Label = %Question
@onready var _yes: Button = %Yes
@onready var _no: Button = %No


func _ready() -> void:
	visible = LessonsDone.is_any()
	_wish.pressed.connect(_ask.bind(true))
	_no.pressed.connect(_ask.bind(false))
	_yes.pressed.connect(_forget)


func _ask(is_asking: bool) -> void:
	_wish.visible = not is_asking
	for part: Control in [_question, _yes, _no]:
		part.visible = is_asking
	# What was pressed is gone: the keys go on with what came for it, and never with the answer
	# that loses something.
	(_no if is_asking else _wish).grab_focus()


func _forget() -> void:
	LessonsDone.forget()
	_ask(false)
	hide()
	forgotten.emit()
