class_name Steps
extends VBoxContainer
## Builds up a drawing from nothing: one sentence for each step, forward and back. Before a step it
## can ask what the student expects.

## The student goes forward; nothing has been asked or shown yet.
signal going_forward
## The student went to another step: the board and the formula have more or less to show.
signal view_changed
## The student went to this step, counted from 0.
signal step_changed(step: int)
## The student goes on behind the last step (1), or back before the first one (-1), where
## [method lead_on] has said that this leads somewhere.
signal led_on(way: int)

## Actions that this service answers to, with what each does in a word for the help line: source
## text.
const ACTIONS: Dictionary[StringName, String] = {
	&"lab_previous_step": "step back", &"lab_next_step": "next step"
}

## A space at which no line ends; see [method kept_together].
const NO_BREAK_SPACE := "\u00a0"

# Where there is less width, the sentence has all of it, below the buttons.
const _NARROW := 400.0
# What a finger can hit: a choice may be one letter.
const _SMALLEST_BUTTON := Vector2(44.0, 44.0)
# The last line of a sentence has at least so many letters, unless that made a piece that is longer
# than the other and may be wider than a narrow panel. A word as short as a unit is never alone.
const _ENDING := 12
const _LONGEST_PIECE := 16
const _SHORTEST_WORD := 4

## The step that is shown, counted from 0: the first one at the start.
var step: int:
	get:
		return _step

## How many steps there are.
var count: int:
	get:
		return _sentences.size()

## The steps, counted from 0, before which the student was asked: there it is asked no more.
var asked_before: PackedInt32Array:
	get:
		return Array(_questions.keys()).filter(
			func(before: int) -> bool: return _questions[before].was_asked
		)
	set(value):
		for before in _questions:
			_questions[before].was_asked = before in value

var _sentences: PackedStringArray = []
var _step := 0
# What is asked, by the step that comes after it.
var _questions: Dictionary[int, Prediction] = {}
# What is asked now, or was answered last: null for nothing.
var _prediction: Prediction
var _is_asking := false
# The place of the choice that the student has made; -1 for none.
var _chosen := -1
# Where the buttons lead to at either end; "" for nowhere.
var _before := ""
var _behind := ""

@onready var _count: Label = %Count
@onready var _answer: Label = %Answer
@onready var _sentence: Label = %Sentence
@onready var _choices: HFlowContainer = %Choices
@onready var _texts: Control = %Texts
@onready var _back: Button = %Back
@onready var _forward: Button = %Forward
@onready var _words_back := _back.tooltip_text
@onready var _words_forward := _forward.tooltip_text


## What the student is asked to predict before a step.
class Prediction:
	## What is asked, translated.
	var prompt: String
	## Asks; returns false where there is nothing to ask.
	var ask: Callable
	## Returns one translated sentence on what was predicted; "" where nothing was.
	var judge: Callable
	## Takes away what the student predicts with.
	var end: Callable
	## It is asked only once.
	var was_asked := false


## [param sentence], its angles in the unit that is chosen, with spaces that do not break where a
## line must not end: beside a sign, as in `a · b`, and in the last few letters, so that no short
## word is left alone in the last line.
static func kept_together(sentence: String) -> String:
	var kept := Conventions.in_unit(sentence)
	for sign_between in "·−=<≤>/+":
		var kept_sign := NO_BREAK_SPACE + sign_between + NO_BREAK_SPACE
		kept = kept.replace(" " + sign_between + " ", kept_sign)
	return with_whole_ending(kept)


## [param text] with no short word left alone in its last line.
static func with_whole_ending(text: String) -> String:
	var words := text.split(" ")
	while words.size() > 1 and words[-1].length() < _ENDING:
		var piece := words[-2] + NO_BREAK_SPACE + words[-1]
		if words[-1].length() >= _SHORTEST_WORD and piece.length() > _LONGEST_PIECE:
			break
		words.remove_at(words.size() - 1)
		words[-1] = piece
	return " ".join(words)


func _ready() -> void:
	resized.connect(_arrange, CONNECT_DEFERRED)
	_back.pressed.connect(go_back)
	_forward.pressed.connect(go_forward)


## Shows these translated sentences, one for each step; the step that is shown stays. Call it before
## the first use of [member step]: it says which step is the last.
func tell(sentences: PackedStringArray) -> void:
	_sentences = sentences
	_step = clampi(_step, 0, sentences.size() - 1)
	_refresh()


## Whether the step that is shown is the last one.
func is_at_end() -> bool:
	return _step == _sentences.size() - 1


## Whether the student is asked something just now: what answers it has to wait.
func is_asking() -> bool:
	return _is_asking


## Goes to a step, counted from 0; stays inside the first and the last. Asks nothing.
func go_to(at: int) -> void:
	_end_prediction()
	_show_step(at)


## From now on one step more than there are leads somewhere: translated words for the buttons say
## where to, [param before] the first step and [param behind] the last one; "" for nowhere.
func lead_on(before: String, behind: String) -> void:
	_before = before
	_behind = behind
	_refresh()


## Goes to the next step, or asks first what is to be asked before it.
func go_forward() -> void:
	going_forward.emit()
	if _is_asking:
		var words: String = _prediction.judge.call()
		_say_answer(words)
		_is_asking = false
		if not _answer.text:
			_end_prediction()
		_show_step(_step + 1)
	elif is_at_end() and _behind:
		led_on.emit(1)
	elif not _asks_before(_step + 1):
		go_to(_step + 1)


## Goes to the previous step, or takes back what is asked.
func go_back() -> void:
	if _is_asking:
		_end_prediction()
	elif _step == 0 and _before:
		led_on.emit(-1)
	else:
		go_to(_step - 1)


## When the student goes to the step [param before] for the first time, asks [param prompt],
## translated, instead; the step is shown when the student goes on. What the three callables do is
## in [Prediction]. Called again for the same step, it only changes them.
func ask_before(before: int, prompt: String, ask: Callable, judge: Callable, end: Callable) -> void:
	var prediction: Prediction = _questions.get_or_add(before, Prediction.new())
	prediction.prompt = prompt
	prediction.ask = ask
	prediction.judge = judge
	prediction.end = end


## The same with a button below the sentence for each of the translated [param choices].
## [param right] returns the place of the right one, below 0 where there is nothing to ask.
func ask_choice_before(
	before: int, prompt: String, choices: PackedStringArray, right: Callable
) -> void:
	var ask := _offer.bind(choices, right)
	ask_before(before, prompt, ask, _judge_choice.bind(choices, right), _clear_choices)


## The student goes on: what was said about the last prediction no longer counts.
func end_answer() -> void:
	if not _is_asking:
		_end_prediction()


## Asks everything once more.
func ask_again() -> void:
	_end_prediction()
	for prediction: Prediction in _questions.values():
		prediction.was_asked = false


func _unhandled_input(event: InputEvent) -> void:
	# A key that is held down goes through the steps, and no further.
	if event.is_action_pressed(&"lab_next_step", not is_at_end(), true):
		go_forward()
	elif event.is_action_pressed(&"lab_previous_step", _step > 0, true):
		go_back()


func _asks_before(next: int) -> bool:
	var wanted: Prediction = _questions.get(next)
	if not wanted or wanted.was_asked:
		return false
	_end_prediction()
	if not wanted.ask.call():
		return false
	wanted.was_asked = true
	_prediction = wanted
	_is_asking = true
	_refresh()
	return true


func _end_prediction() -> void:
	if not _prediction:
		return
	_prediction.end.call()
	_prediction = null
	_is_asking = false
	_say_answer("")
	_refresh()


func _show_step(at: int) -> void:
	if _sentences.is_empty():
		return
	var wanted := clampi(at, 0, _sentences.size() - 1)
	if wanted != _step:
		_step = wanted
		_refresh()
		step_changed.emit(_step)
		view_changed.emit()


func _offer(choices: PackedStringArray, right: Callable) -> bool:
	if right.call() < 0:
		return false
	_chosen = -1
	for i in choices.size():
		var button := Button.new()
		button.text = Conventions.in_unit(choices[i])
		button.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
		button.theme_type_variation = &"ButtonSmall"
		button.custom_minimum_size = _SMALLEST_BUTTON
		button.pressed.connect(_choose.bind(i))
		_choices.add_child(button)
	return true


func _choose(place: int) -> void:
	_chosen = place
	go_forward()


func _judge_choice(choices: PackedStringArray, right: Callable) -> String:
	_clear_choices()
	var wanted: int = right.call()
	if _chosen < 0 or wanted < 0:
		return ""
	var answer := Conventions.in_unit(choices[wanted])
	return (tr("Right: %s") if _chosen == wanted else tr("No, %s")) % answer


func _clear_choices() -> void:
	for button in _choices.get_children():
		button.queue_free()


# The sentence beside the buttons, or below them.
func _arrange() -> void:
	var place: Control = self if size.x < _NARROW else _texts
	for part: Control in [_sentence, _choices]:
		if part.get_parent() != place:
			part.reparent(place, false)


# Without one the line of the count has no room to keep for it.
func _say_answer(words: String) -> void:
	_answer.text = words
	_answer.visible = words != ""


func _refresh() -> void:
	_count.text = tr("Step %d of %d") % [_step + 1, _sentences.size()]
	_sentence.text = kept_together(_prediction.prompt if _is_asking else _sentences[_step])
	var leads_back := _step == 0 and not _is_asking and _before != ""
	_label(_back, _before if leads_back else _words_back)
	_label(_forward, _behind if is_at_end() and _behind else _words_forward)
	_back.disabled = _step == 0 and not _is_asking and not _before
	_forward.disabled = is_at_end() and not _behind


func _label(button: Button, words: String) -> void:
	button.tooltip_text = words
	button.accessibility_name = words
