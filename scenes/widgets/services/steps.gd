class_name Steps
extends HBoxContainer
## Builds up a drawing from nothing: one sentence for each step, forward and back.

## The student went to another step: the board and the formula have more or less to show.
signal view_changed
## The student went to this step, counted from 0.
signal step_changed(step: int)

## Actions that this service answers to, for the help line.
const ACTIONS: Array[StringName] = [&"lab_previous_step", &"lab_next_step"]

## The step that is shown, counted from 0. The last one at first, unless [method open_at] names
## another.
var step: int:
	get:
		return _step

var _sentences: PackedStringArray = []
var _step := 0
# Whether it is known which step is shown.
var _is_open := false

@onready var _count: Label = %Count
@onready var _sentence: Label = %Sentence
@onready var _back: Button = %Back
@onready var _forward: Button = %Forward


func _ready() -> void:
	_back.pressed.connect(func() -> void: go_to(_step - 1))
	_forward.pressed.connect(func() -> void: go_to(_step + 1))


## Opens at the step [param first], counted from 0; before the first [method tell].
func open_at(first: int) -> void:
	_step = first
	_is_open = true


## Shows these translated sentences, one for each step; the step that is shown stays. Call it before
## the first use of [member step]: it says which step is the last.
func tell(sentences: PackedStringArray) -> void:
	var last := sentences.size() - 1
	_sentences = sentences
	_step = clampi(_step, 0, last) if _is_open else last
	_is_open = true
	_refresh()


## Goes to a step, counted from 0; stays inside the first and the last.
func go_to(at: int) -> void:
	if _sentences.is_empty():
		return
	var wanted := clampi(at, 0, _sentences.size() - 1)
	if wanted != _step:
		_step = wanted
		_refresh()
		step_changed.emit(_step)
		view_changed.emit()


func _unhandled_input(event: InputEvent) -> void:
	if event.is_action_pressed(&"lab_next_step", true, true):
		go_to(_step + 1)
	elif event.is_action_pressed(&"lab_previous_step", true, true):
		go_to(_step - 1)


func _refresh() -> void:
	_count.text = tr("Step %d of %d") % [_step + 1, _sentences.size()]
	_sentence.text = _sentences[_step]
	_back.disabled = _step == 0
	_forward.disabled = _step == _sentences.size() - 1
