@tool
class_name OwnFlight
extends OwnDrawing
## The student's ball among the lesson's lines: it flies beside the selected one, by his `step`. His
## last answer is the next question, one a frame. It begins where the lab's ball is whenever
## something other than time changes.

const _METHOD := "step"
# Numbers of a ball that he changes: place and velocity.
const _MOVING := 4
# So many places are drawn, and kept to go back.
const _MOST_PLACES := 600

# His ball in each frame, the latest last; never empty once the board is known.
var _states: Array[PackedFloat64Array] = []
# What follows it in each question: radius, gravity, lines, seconds.
var _surroundings: PackedFloat64Array = []
# How many frames the lab's ball is ahead.
var _behind := 0
# The number of what was asked and is not answered yet; 0 for nothing.
var _asked := 0
var _can_fly := false
var _is_old := false


## For the board of [param lesson], from what [param watcher] hears.
func _init(lesson: Lesson, watcher: WorkshopWatcher) -> void:
	super(lesson, watcher)
	watcher.began.connect(_grow_old)
	watcher.judged.connect(_follow_verdict)
	watcher.answered.connect(_take)
	# What is to be shown has changed by then.
	lesson.about_to_show.connect(_begin)
	(lesson.get_node(^"%Player") as AngledLinesPlayer).stepped.connect(_follow_step)


func _ready() -> void:
	_begin()
	if _watcher.report:
		_follow_verdict(_watcher.report)


func _process(seconds: float) -> void:
	super(seconds)
	_ask()


## The place and the velocity of his ball, as it is shown.
func ball() -> PackedFloat64Array:
	return _states[-1]


## Whether his ball is shown.
func is_flying() -> bool:
	return _can_fly and not _surroundings.is_empty()


## Whether it has flown as many frames as the lab's.
func is_current() -> bool:
	return _behind == 0 and _asked == 0


# His method knows lines that end, and a bounciness of 1.
func _begin() -> void:
	var state := _lesson.link_state()
	var selected: int = state["selected"]
	var balls: Array[PackedFloat64Array] = state["balls"]
	var gravity: PackedFloat64Array = state["gravity"]
	var lines: Array[PackedFloat64Array] = state["lines"]
	_states = [balls[selected].slice(0, _MOVING)]
	_surroundings = balls[selected].slice(_MOVING) + gravity
	for line in lines:
		_surroundings.append_array(line)
	_surroundings.append(AngledLinesModel.FRAME)
	if state["endless"] or state["bounciness"] != 1.0:
		_surroundings.clear()
	_behind = 0
	_asked = 0
	queue_redraw()


func _follow_step(is_forward: bool) -> void:
	if not is_flying():
		return
	if is_forward:
		_behind += 1
	elif _behind > 0:
		_behind -= 1
	elif _states.size() > 1:
		_states.remove_at(_states.size() - 1)
		_asked = 0
	queue_redraw()


func _grow_old() -> void:
	_is_old = true
	queue_redraw()


# With another file his ball begins where the lab's is now.
func _follow_verdict(report: WorkshopReport) -> void:
	_asked = 0
	if not report.is_complete:
		return
	_can_fly = report.can_ask(_METHOD)
	if _is_old:
		_is_old = false
		_begin()
	queue_redraw()


func _ask() -> void:
	if _behind > 0 and _asked == 0 and _can_fly and _is_finite():
		_asked = _watcher.ask(_METHOD, _states[-1] + _surroundings)


func _take(number: int, numbers: PackedFloat64Array) -> void:
	if number != _asked:
		return
	_asked = 0
	_behind = maxi(_behind - 1, 0)
	if numbers.size() == _MOVING:
		_states.append(numbers)
		if _states.size() > _MOST_PLACES:
			_states.remove_at(0)
	# Not a frame later: the lab makes a step in each.
	_ask()
	queue_redraw()


func _is_finite() -> bool:
	for number in _states[-1]:
		if not is_finite(number):
			return false
	return is_flying()


func _draw() -> void:
	if not is_flying() or not _is_finite():
		return
	var color := ink(_is_old)
	_draw_path(color)
	var radius := _surroundings[0]
	var center := Vec2.new(_states[-1][0], _states[-1][1])
	draw_ball(center, radius, false, color)
	var above := Vector2(0.0, -radius * board.pixels_per_unit - 16.0)
	draw_text(tr("yours"), board.to_screen(center) + above, color)


# A dash for every second frame.
func _draw_path(color: Color) -> void:
	var dashes: PackedVector2Array = []
	for at in range(1, _states.size(), 2):
		for state: PackedFloat64Array in [_states[at - 1], _states[at]]:
			dashes.append(board.to_screen(Vec2.new(state[0], state[1])))
	if dashes:
		draw_multiline(dashes, color, Palette.stroke(3.0))
