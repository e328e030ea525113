extends PanelContainer
## The start screen: a card for every lesson, under the headings of the agenda, and behind them what
## the lab has besides lessons.

const _CARD := preload("res://scenes/shell/lesson_card.tscn")
const _HEADING := preload("res://scenes/shell/lesson_heading.tscn")

## Its actions, with what each does in a word for the help line: source text.
const ACTIONS: Dictionary[StringName, String] = {
	&"lab_preset_1": "lesson",
	&"lab_preset_2": "lesson",
	&"lab_preset_3": "lesson",
	&"lab_preset_4": "lesson",
	&"lab_preset_5": "lesson",
	&"lab_preset_6": "lesson",
	&"lab_preset_7": "lesson",
	&"lab_preset_8": "lesson",
	&"lab_preset_9": "lesson",
	&"lab_preset_0": "lesson 10",
	&"ui_left": "move",
	&"ui_up": "move",
	&"ui_down": "move",
	&"ui_right": "move",
	&"ui_home": "first",
	&"ui_end": "last",
	&"ui_focus_next": "next part",
	&"ui_accept": "open",
}

const _FRAMES_TO_LAY := 3
# The setting that names the scene of what is shown behind the lessons. Its `add_to(shelf)` returns
# actions with their purposes, as in ACTIONS. A setting, because no export holds that scene.
const _BESIDES := "vec2_lab/start_screen/besides"

## The lesson from which the student comes back: its card has the focus. Null at the first start.
var came_from: LessonInfo

var _frames_until_laid := 0
var _purposes: Dictionary[StringName, String] = ACTIONS.duplicate()

@onready var _scroll: ScrollContainer = %Scroll
@onready var _shelf: LessonShelf = %Cards
@onready var _forget: ForgetRow = %Forget
@onready var _help: Label = %Help
@onready var _language: Button = %Language


func _ready() -> void:
	var options := ViewOptions.begin(self)
	options.language_changed.connect(_open_again)
	for part in LessonAgenda.parts():
		_add_part(part)
	_add_besides()
	_show_done()
	_forget.forgotten.connect(_show_forgotten)
	_language.text = LabText.name_of(LabText.next_language())
	_language.pressed.connect(options.speak_next_language)
	_help.text = InputHelp.line(_purposes, false)
	_help.visible = not DisplayServer.is_touchscreen_available()
	_focus(came_from)
	add_child(LinkPaste.new(_follow_link, _refuse))
	var id := LessonRequest.take_id()
	open_requested(id)
	if not LessonIndex.find(id):
		LessonAddress.tell_page_of_start()
	WebPage.follow_fragment(_follow_link)
	PageText.tell_page(self, [self])
	PageFocus.tell_page(self)


## Opens the lesson with this id, or says which ids there are; does nothing for "".
func open_requested(id: String) -> void:
	if not id:
		return
	var lesson := LessonIndex.find(id)
	if lesson:
		LessonBoards.forget(lesson.id)
		Navigation.open_lesson(get_tree(), lesson)
	else:
		_refuse(LessonIndex.refusal(id))


# Whoever uses a finger has no keys to be told of, until one is pressed.
func _input(event: InputEvent) -> void:
	if event is InputEventScreenTouch:
		_help.hide()
	elif event is InputEventKey or event is InputEventJoypadButton:
		_help.show()
		_help.text = InputHelp.line(_purposes, event is InputEventJoypadButton)


func _unhandled_input(event: InputEvent) -> void:
	if event.is_action_pressed(&"ui_home", false, true):
		_focus_card(_shelf.cards()[0])
	elif event.is_action_pressed(&"ui_end", false, true):
		_focus_card(_shelf.cards()[-1])
	for card in _lesson_cards():
		# Only the first ten lessons have a digit.
		var number := LessonIndex.number_of(card.lesson)
		if number > 10 or number < 1:
			continue
		if event.is_action_pressed("lab_preset_%d" % (number % 10), false, true):
			Navigation.open_lesson(get_tree(), card.lesson)
			return


func _open_again() -> void:
	get_tree().reload_current_scene.call_deferred()


func _refuse(sentence: String) -> void:
	(%Notice as Label).text = sentence
	(%NoticePlace as Control).show()


func _follow_link(text: String) -> void:
	LessonRequest.ask(text)
	open_requested(LessonRequest.take_id())


func _add_part(part: LessonAgenda.Part) -> void:
	var heading := _HEADING.instantiate() as LessonHeading
	_shelf.add_child(heading)
	heading.show_part(part)
	for lesson in part.lessons:
		var card := _CARD.instantiate() as LessonCard
		_shelf.add_child(card)
		card.show_lesson(lesson)
		card.pressed.connect(Navigation.open_lesson.bind(get_tree(), lesson))


func _add_besides() -> void:
	var scene: String = ProjectSettings.get_setting(_BESIDES, "")
	if ResourceLoader.exists(scene):
		var besides := (load(scene) as PackedScene).instantiate()
		add_child(besides)
		var actions: Dictionary[StringName, String] = besides.call(&"add_to", _shelf)
		_purposes.merge(actions)


func _lesson_cards() -> Array[LessonCard]:
	var found: Array[LessonCard] = []
	for card in _shelf.cards():
		if card is LessonCard:
			found.append(card as LessonCard)
	return found


# The first lesson that has not been seen is where to start.
func _show_done() -> void:
	var is_found := false
	for card in _lesson_cards():
		var is_seen := LessonsDone.has(LessonsDone.SEEN, card.lesson.id)
		card.show_done(not is_seen and not is_found)
		is_found = is_found or not is_seen
	_shelf.queue_sort()


func _show_forgotten() -> void:
	_show_done()
	_focus_card(_shelf.cards()[0])


# The card of a lesson, or the first one where there is none for it.
func _focus(lesson: LessonInfo) -> void:
	for card in _lesson_cards():
		if card.lesson == lesson:
			_focus_card(card)
			return
	_focus_card(_shelf.cards()[0])


# The cards have their places only after they are laid out, which takes some frames.
func _focus_card(card: ShelfCard) -> void:
	card.grab_focus()
	_frames_until_laid = _FRAMES_TO_LAY
	set_process(true)


func _process(_delta: float) -> void:
	_frames_until_laid -= 1
	if _frames_until_laid > 0:
		return
	set_process(false)
	var focused := get_viewport().gui_get_focus_owner()
	# The heading above the first card is seen, too.
	if focused == _shelf.cards()[0]:
		_scroll.scroll_vertical = 0
	elif focused is ShelfCard:
		_scroll.ensure_control_visible(focused)
