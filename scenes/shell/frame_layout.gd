class_name FrameLayout
extends Node
## Where the parts of the lesson frame are, for the size of its window: the board above the panel or
## beside it, the buttons that have no room in the top bar below the board, the panel folded away.

## The panel was folded away or shown, or what stands in the menu has changed otherwise.
signal changed

## In the top bar of a tall window of less width there is room for four buttons.
const NARROW := 600.0
## A window of less height has no room for a line of help.
const LOW := 500.0
## The panel takes this share of the width beside the board, or of the height below it.
const PANEL_BESIDE := 0.42
const PANEL_BELOW := 0.44
## It is at least and at most so wide beside the board.
const NARROWEST_PANEL := 280.0
const WIDEST_PANEL := 450.0

# Of a long title so many lines are shown in a narrow window.
const _TITLE_LINES := 3
const _KEY := "panel"

var _frame: Control

@onready var _body: BoxContainer = _frame.get_node("%Body")
@onready var _top_row: BoxContainer = _frame.get_node("%TopRow")
@onready var _below_board: Control = _frame.get_node("%BelowBoard")
@onready var _row_below: BoxContainer = _frame.get_node("%RowBelowBoard")
@onready var _panel: Control = _frame.get_node("%Panel")
@onready var _panel_place: Control = _frame.get_node("%PanelPicture")
@onready var _foot: Control = _frame.get_node("%Foot")
@onready var _title: Label = _frame.get_node("%Title")
@onready var _fold: Button = _frame.get_node("%FoldPanel")
# What goes below the board, in its order, where the top bar has no room for it.
@onready var _movable: Array[Control] = [
	_frame.get_node("%Undo"),
	_frame.get_node("%Redo"),
	_frame.get_node("%Reset"),
	_frame.get_node("%CopyLink"),
	_fold,
]


## Of this lesson frame.
func _init(frame: Control) -> void:
	_frame = frame


func _ready() -> void:
	_fold.toggled.connect(keep_panel)
	_frame.resized.connect(fit)
	# Texts that wrap anew change their height after the panel has been laid out.
	var services: Control = _frame.get_node("%Services")
	var margin: MarginContainer = services.get_parent()
	services.resized.connect(margin.queue_sort, CONNECT_DEFERRED)
	var is_wanted: bool = KeptChoices.value(_KEY, true)
	show_panel(is_wanted)
	fit()


## Whether the panel is shown.
func has_panel() -> bool:
	return _panel_place.visible


## Shows the panel, or folds it away: the board then has the whole window.
func show_panel(wanted: bool) -> void:
	_panel_place.visible = wanted
	_fold.set_pressed_no_signal(wanted)
	changed.emit()


## The same as the student's choice, kept for the next time.
func keep_panel(wanted: bool) -> void:
	KeptChoices.keep(_KEY, wanted)
	show_panel(wanted)


## Lays everything out for the size that the frame has now.
func fit() -> void:
	var extent := _frame.size
	var is_tall := extent.y > extent.x
	var is_narrow := extent.x < NARROW
	_body.vertical = is_tall
	var width := clampf(extent.x * PANEL_BESIDE, NARROWEST_PANEL, WIDEST_PANEL)
	_panel.custom_minimum_size = (
		Vector2(0.0, extent.y * PANEL_BELOW) if is_tall else Vector2(width, 0.0)
	)
	_title.theme_type_variation = &"LabelSmallTitle" if is_narrow else &"LabelTitle"
	_title.max_lines_visible = _TITLE_LINES if is_narrow else -1
	_title.text_overrun_behavior = (
		TextServer.OVERRUN_TRIM_ELLIPSIS if is_narrow else TextServer.OVERRUN_NO_TRIMMING
	)
	_below_board.visible = is_narrow and is_tall
	_put_buttons(_row_below if _below_board.visible else _top_row)
	show_help()


## Shows the line of help where there are room and a keyboard.
func show_help() -> void:
	var has_room := _frame.size.x >= NARROW and _frame.size.y >= LOW
	_foot.visible = has_room and Keyboard.is_there


# Each time in the same order, so that Tab goes through them as they are seen.
func _put_buttons(row: BoxContainer) -> void:
	for button in _movable:
		if button.get_parent() != row:
			button.reparent(row, false)
		row.move_child(button, -1)
	_frame.get_node("%View").get_parent().move_child(_frame.get_node("%View"), -1)
