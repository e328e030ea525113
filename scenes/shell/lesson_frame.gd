class_name LessonFrame
extends PanelContainer
## The lesson frame: title, board, panel with the services that the lesson needs, help, undo.

## The student wants to leave. A way back is offered only where something listens.
signal left
## A link to another lesson is to be opened.
signal other_lesson_wanted(lesson: LessonInfo)

## The scene of a service, `%` the name in [member LessonInfo.needs].
const SERVICE_SCENE := "res://scenes/widgets/services/%s.tscn"

# The frame's own actions, with what each does in a word: source text.
const _ACTIONS: Dictionary[StringName, String] = {
	&"lab_reset": "reset",
	&"lab_undo": "undo",
	&"lab_redo": "redo",
	&"lab_copy_link": "copy link",
	&"lab_hide_answers": "hide answers",
	&"lab_motion": "motion",
	&"lab_view": "view",
	&"ui_focus_next": "next part",
}
# Only where there is a way back: source text.
const _WAY_BACK: Dictionary[StringName, String] = {&"lab_back": "back"}
const _NO_ACTIONS: Dictionary[StringName, String] = {}

## The lesson to open, set before the lesson frame enters the tree; else the first one. A demo
## holds only one.
var lesson_info: LessonInfo

## All lessons in the order in which the ways between them lead; none in a demo.
var lessons: Array[LessonInfo] = []

## The lesson inside.
var lesson: Lesson

## The link to its board.
var link: BoardLink

## How it is shown, with the menu for that.
var view: FrameView

# Null where the lesson could not be opened, as is the link.
var _history: LessonHistory
var _purposes: Dictionary[StringName, String] = _ACTIONS.duplicate()

@onready var _board_place: Control = %BoardPlace
@onready var _services: VBoxContainer = %Services
@onready var _panel: ScrollContainer = %Panel
@onready var _notice: Label = %Notice
@onready var _notice_place: PanelContainer = %NoticePlace
@onready var _help: Label = %Help
@onready var _undo: Button = %Undo
@onready var _redo: Button = %Redo
@onready var _ways: LessonWays = %Ways


## Notes the first error that is logged while it listens.
class ErrorCatcher:
	extends Logger
	## What went wrong; "" while nothing did.
	var first := ""

	func _log_error(
		function: String,
		file: String,
		line: int,
		code: String,
		rationale: String,
		_editor_notify: bool,
		error_type: int,
		_script_backtraces: Array[ScriptBacktrace]
	) -> void:
		if first or error_type == ERROR_TYPE_WARNING:
			return
		var what := rationale if rationale else code
		first = "%s (%s:%d, %s)" % [what, file.get_file(), line, function]


func _ready() -> void:
	if not lesson_info:
		lesson_info = LessonIndex.all()[0]
	var options := ViewOptions.begin(self)
	options.language_changed.connect(open_again)
	LinkView.choose_language(LessonRequest.state_for(lesson_info.id))
	view = FrameView.new(self, options)
	add_child(view)
	SoftwareDrawing.fill_window(get_window(), true)
	(%Title as Label).text = heading()
	_offer_way_back()
	add_child(LinkPaste.new(follow_link, _show_notice))
	(%Reset as Button).pressed.connect(_act.bind(&"lab_reset"))
	(%CopyLink as Button).pressed.connect(_act.bind(&"lab_copy_link"))
	_undo.pressed.connect(_act.bind(&"lab_undo"))
	_redo.pressed.connect(_act.bind(&"lab_redo"))
	_open()
	_refresh_buttons()
	_show_help(false)
	PageText.tell_page(self, [%Title as Control, _board_place, _panel])
	PageFocus.tell_page(self)
	if not Keyboard.is_there:
		add_child(MouseTooltips.new())


## The lesson's number and title. A lesson that is not in the index has no number.
func heading() -> String:
	return LessonIndex.heading_of(lesson_info)


## Opens a link such as `#dot_product?a=7,1`: in this lesson as a change that can be undone. An
## empty one is the address of the start screen.
func follow_link(text: String) -> void:
	_end_drags()
	_show_notice("")
	if not LessonRequest.id_in(text):
		left.emit()
		return
	LessonRequest.ask(text)
	_open_requested()
	if _history:
		_history.store()


## Builds the screen anew, as after a change of the language; board and step stay.
func open_again() -> void:
	LessonBoards.keep(lesson_info.id, view)
	if other_lesson_wanted.has_connections():
		other_lesson_wanted.emit(lesson_info)
	else:
		get_tree().reload_current_scene.call_deferred()


func _exit_tree() -> void:
	SoftwareDrawing.fill_window(get_window(), false)


func _unhandled_input(event: InputEvent) -> void:
	if event.is_action_pressed(&"lab_back"):
		left.emit()
	for action: StringName in [&"lab_undo", &"lab_redo", &"lab_reset", &"lab_copy_link"]:
		if event.is_action_pressed(action, false, true):
			_act(action)


func _input(event: InputEvent) -> void:
	if event.is_pressed():
		# A notice is shown until the next input, which may bring another.
		_show_notice("")
		# A key may remove what is dragged, and two fingers are for the page.
		var touch := event as InputEventScreenTouch
		if touch and touch.index > 0 or _is_action(event):
			_end_drags()
	if event is InputEventMouseButton and not event.is_pressed():
		_release_button.call_deferred()
	if (
		event.is_action_pressed(&"ui_focus_next", true)
		or event.is_action_pressed(&"ui_focus_prev", true)
	):
		_pass_by_what_is_off()
	if event is InputEventKey:
		_show_help(false)
	elif event is InputEventJoypadButton:
		_show_help(true)


# What the focused control uses is no shortcut besides: Space on a button presses it, and no more.
func _unhandled_key_input(event: InputEvent) -> void:
	var focused := get_viewport().gui_get_focus_owner()
	if event.is_action(&"ui_accept") and focused is BaseButton:
		get_viewport().set_input_as_handled()


# A clicked button would keep the focus, and with it take Space and the arrow keys from the lesson.
func _release_button() -> void:
	if get_viewport().gui_get_focus_owner() is BaseButton:
		get_viewport().gui_release_focus()


# The list of an [OptionButton] is a window of its own, which sees the click in it.
func _release_lists() -> void:
	for list: OptionButton in find_children("*", "OptionButton", true, false):
		list.get_popup().about_to_popup.connect(_release_list.bind(list))


func _release_list(list: OptionButton) -> void:
	# A list that was opened by a key is gone on with by keys.
	if Input.get_mouse_button_mask():
		list.get_popup().popup_hide.connect(list.release_focus, CONNECT_ONE_SHOT | CONNECT_DEFERRED)


# Tab stops only where something can be done, and goes on from what its own press has switched off.
func _pass_by_what_is_off() -> void:
	for button: BaseButton in find_children("*", "BaseButton", true, false):
		var is_on := not button.disabled or button.has_focus()
		button.focus_mode = FOCUS_ALL if is_on else FOCUS_NONE


func _notification(what: int) -> void:
	if what == NOTIFICATION_WM_WINDOW_FOCUS_OUT:
		_end_drags()


func _is_action(event: InputEvent) -> bool:
	return InputMap.get_actions().any(event.is_action_pressed.bind(true))


# Whatever is dragged is let go where it is.
func _end_drags() -> void:
	if lesson:
		lesson.propagate_call(&"end_drag")


func _open() -> void:
	var errors := ErrorCatcher.new()
	OS.add_logger(errors)
	_start_lesson()
	OS.remove_logger(errors)
	WebPage.follow_fragment(follow_link)
	if other_lesson_wanted.has_connections():
		_announce(_ways)
		_ways.wanted.connect(other_lesson_wanted.emit)
		_ways.offer(lesson_info, lessons, lesson)
	if errors.first:
		_say_why_not_opened(errors.first)
		return
	_history = LessonHistory.new(lesson)
	_history.changed.connect(_refresh_buttons)
	lesson.edited.connect(_history.store)
	lesson.motion_ended.connect(_history.store_motion)
	link = BoardLink.new(lesson_info.id, view)
	_open_requested()
	_history.begin_here()
	if WebPage.is_there():
		_tell_page()


# A demo alone adds no entry to the browser's history.
func _tell_page() -> void:
	var address := LessonAddress.new(lesson_info.id, link)
	add_child(address)
	var changes: Array[Signal] = [_history.changed, lesson.step_changed, Conventions.changed()]
	address.tell_page(heading(), left.has_connections(), changes)


func _start_lesson() -> void:
	lesson = (load(lesson_info.scene_path()) as PackedScene).instantiate() as Lesson
	for need in lesson_info.needs:
		lesson.services[StringName(need)] = _add_service(need)
	_announce(lesson)
	lesson.set_anchors_preset(Control.PRESET_FULL_RECT)
	_board_place.add_child(lesson)
	lesson.noticed.connect(_show_notice)
	lesson.start()
	view.lesson = lesson
	_release_lists()


# In place of the lesson, which may be half built.
func _say_why_not_opened(why: String) -> void:
	if lesson:
		lesson.queue_free()
	lesson = null
	view.lesson = null
	for service in _services.get_children():
		service.queue_free()
	for button: Button in [%Reset, %CopyLink]:
		button.disabled = true
	var words := Label.new()
	words.text = tr("The lesson “%s” could not be opened: %s") % [lesson_info.id, why]
	words.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	words.vertical_alignment = VERTICAL_ALIGNMENT_CENTER
	words.set_anchors_and_offsets_preset(PRESET_FULL_RECT, PRESET_MODE_MINSIZE, 24)
	var paper := ColorRect.new()
	paper.color = Palette.drawn(Palette.PAPER)
	paper.set_anchors_preset(PRESET_FULL_RECT)
	_board_place.add_child(paper)
	_board_place.add_child(words)
	_notice_place.move_to_front()


func _add_service(need: String) -> Control:
	var service := (load(SERVICE_SCENE % need) as PackedScene).instantiate() as Control
	take_in(service)
	return service


## Takes a service into the panel, as the last one. A lesson's own are there before it is seen; what
## the whole lab adds comes later.
func take_in(service: Control) -> void:
	_announce(service)
	_services.add_child(service)
	if service.has_signal(&"refused"):
		service.connect(&"refused", _show_notice)
	if service.has_signal(&"role_pointed"):
		service.connect(&"role_pointed", lesson.light)
	if service is FoldableContainer:
		service.connect(&"folding_changed", _keep_in_view.bind(service).unbind(1))
	if service.has_signal(&"board_wanted"):
		service.resized.connect(_keep_in_view.bind(service))
	if service.has_signal(&"mistake_picked"):
		service.connect(&"mistake_picked", _keep_in_view.bind(service).unbind(1))
	if view.lesson:
		_show_help(false)


# A service or lesson with keys of its own lists their actions and purposes in a constant ACTIONS.
func _announce(answering: Node) -> void:
	var script: Script = answering.get_script()
	var actions: Dictionary[StringName, String] = script.get_script_constant_map().get(
		"ACTIONS", _NO_ACTIONS
	)
	_purposes.merge(actions)


# What has been unfolded, has grown by a verdict, or tells of a mistake that was picked is scrolled
# into view. The panel knows in the next frame how far it can be scrolled.
func _keep_in_view(service: Control) -> void:
	if service.get(&"folded"):
		return
	var scroll := _panel.ensure_control_visible.bind(service)
	get_tree().process_frame.connect(scroll, CONNECT_ONE_SHOT | CONNECT_REFERENCE_COUNTED)


func _act(action: StringName) -> void:
	if not _history:
		return
	match action:
		&"lab_undo":
			_history.undo()
		&"lab_redo":
			_history.redo()
		&"lab_reset":
			_history.reset()
		&"lab_copy_link":
			var problem := link.problem()
			_show_notice(problem if problem else link.copy(), not problem)


# Opens what was asked for: a state of this lesson's board, or another lesson.
func _open_requested() -> void:
	var id := LessonRequest.take_id()
	var wanted := LessonIndex.find(id) if id else lesson_info
	if not wanted:
		_show_notice(LessonIndex.refusal(id))
	elif wanted != lesson_info or not link:
		LessonBoards.forget(wanted.id)
		other_lesson_wanted.emit(wanted)
	else:
		_open_state(LessonRequest.take_state(lesson_info.id), id != "")


# A link that names only the lesson asks for its start. Without a link the lesson is as it was
# left.
func _open_state(text_of_state: String, is_named: bool) -> void:
	if not text_of_state and not is_named:
		LessonBoards.bring_back(lesson_info.id, view)
	else:
		_show_notice(link.open(text_of_state))


func _offer_way_back() -> void:
	var back := %Back as Button
	back.visible = left.has_connections()
	back.pressed.connect(left.emit)
	if back.visible:
		_purposes = _WAY_BACK.merged(_purposes)


# A refusal lies on the board. Good news looks otherwise and lies beside it: there it hides no
# verdict.
func _show_notice(message: String, is_news: bool = false) -> void:
	_notice.text = message
	_notice_place.visible = message != ""
	_notice_place.theme_type_variation = &"PanelCard" if is_news else &"PanelNotice"
	var below: Control = _panel if is_news and _panel.is_visible_in_tree() else _board_place
	var corner := below.global_position - _board_place.global_position + Vector2(10.0, 10.0)
	_notice_place.set_begin(corner)
	_notice_place.set_end(corner + Vector2(below.size.x - 20.0 - _board_place.size.x, 0.0))


func _show_help(for_joypad: bool) -> void:
	_help.text = InputHelp.line(_purposes, for_joypad)
	view.layout.show_help()


func _refresh_buttons() -> void:
	_undo.disabled = not _history or not _history.has_undo()
	_redo.disabled = not _history or not _history.has_redo()
