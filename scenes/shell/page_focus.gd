class_name PageFocus
extends Node
## Tells the page around the lab what is for the lab and what for the page: the Tab key, which
## leaves the lab behind its last part, and the wheel, which scrolls what can be scrolled.

## What [method state] returns has changed.
signal changed(state: Dictionary)

## Seconds between two looks at the parts that Tab reaches, where the focus stays.
const INTERVAL := 0.25
# More parts in a row that are off than there ever are.
const _MOST_OFF := 100

var _screen: Control
var _state := {}
var _ends := {}
var _seconds := INTERVAL


## Of all that is on [param screen].
func _init(screen: Control) -> void:
	_screen = screen


## From now on the page is told of [param screen].
static func tell_page(screen: Control) -> void:
	if not WebPage.is_there():
		return
	var focus := PageFocus.new(screen)
	focus.changed.connect(WebPage.tell)
	screen.add_child(focus)
	WebPage.follow_entering(screen.get_viewport().gui_release_focus)


## Whether Tab leads out of the lab: `isFirst` with Shift, `isLast` without; and whether there is
## something to scroll below the pointer: `scrollsUp`, `scrollsDown`.
func state() -> Dictionary:
	return _find_ends().merged(_scrolling())


func _ready() -> void:
	get_viewport().gui_focus_changed.connect(func(_part: Control) -> void: _seconds = INTERVAL)


func _process(delta: float) -> void:
	_seconds += delta
	if _seconds >= INTERVAL:
		_seconds = 0.0
		_ends = _find_ends()
	var now := _ends.merged(_scrolling())
	if now != _state:
		_state = now
		changed.emit(now)


# Tab goes round, from the last part to the first one.
func _find_ends() -> Dictionary:
	var first := _next_to(_screen)
	var part := get_viewport().gui_get_focus_owner()
	return {
		"isFirst": part == null or part == first,
		"isLast": part != null and _next_to(part) == first,
	}


# What is off is passed by.
func _next_to(part: Control) -> Control:
	var next := part.find_next_valid_focus()
	for i: int in _MOST_OFF:
		if next is not BaseButton or not (next as BaseButton).disabled:
			break
		next = next.find_next_valid_focus()
	return next


func _scrolling() -> Dictionary:
	var scrolls_up := false
	var scrolls_down := false
	var above: Node = get_viewport().gui_get_hovered_control()
	while above:
		if above is ScrollContainer:
			var bar := (above as ScrollContainer).get_v_scroll_bar()
			scrolls_up = scrolls_up or bar.value > bar.min_value
			scrolls_down = scrolls_down or bar.value < bar.max_value - bar.page
		above = above.get_parent()
	return {"scrollsUp": scrolls_up, "scrollsDown": scrolls_down}
