class_name Mistakes
extends VBoxContainer
## The bug gallery: one known mistake at a time runs beside the right way, and is named.

## The student has switched a mistake on, by its number; 0 switches all off.
signal mistake_picked(number: int)
## The same as a change of the lesson's state: `{"mistake": number}`.
signal picked(changes: Dictionary)

var _mistakes: Array[MistakeInfo] = []

@onready var _list: OptionButton = %List
@onready var _sentence: Label = %Sentence


func _ready() -> void:
	_list.item_selected.connect(_pick)
	_list.add_item(tr("No mistake"))


## Adds mistakes to the list.
func add_all(mistakes: Array[MistakeInfo]) -> void:
	_mistakes.append_array(mistakes)
	for mistake in mistakes:
		_list.add_item(mistake.heading())


## Shows the mistake in a lesson's state as switched on, if the state has one; emits nothing.
func show_picked(state: Dictionary) -> void:
	if state.has("mistake"):
		var number: int = state["mistake"]
		_show_mistake(number)


# Shows the mistake with this number as switched on, 0 for none.
func _show_mistake(number: int) -> void:
	_list.select(0)
	_sentence.text = ""
	for i in _mistakes.size():
		if _mistakes[i].number == number:
			_list.select(i + 1)
			_sentence.text = "\n".join([_mistakes[i].sentence, _mistakes[i].checks]).strip_edges()
	_sentence.visible = _sentence.text != ""


func _pick(item: int) -> void:
	var number := _mistakes[item - 1].number if item > 0 else 0
	_show_mistake(number)
	mistake_picked.emit(number)
	picked.emit({"mistake": number})
