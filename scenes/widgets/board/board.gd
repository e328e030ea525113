@tool
class_name Board
extends Control
## The plane that a lesson draws on: says where a point of the plane is on the screen, and back.
##
## One unit of the plane is a pixel of the course; the board shows it larger. y points down, as on
## the screen, unless [member is_y_up]. This is the one place of the view where [Vec2] meets
## [Vector2].

## Scale, middle or size changed: what is drawn on the board has to be drawn again.
signal view_changed
## The empty board was clicked, with `MOUSE_BUTTON_LEFT` or `MOUSE_BUTTON_RIGHT`, or is being
## dragged on.
signal pointed(at: Vec2, button: MouseButton)
## The click or drag that [signal pointed] told of has ended.
signal released

## Every handle on a board is in this group.
const HANDLES := &"handles"
## A step of the grid is never narrower on screen than this, in pixels.
const NARROWEST_STEP := 24.0
## On a board with a side below this, in pixels, steps may be narrower: handles go on snapping to
## whole units there.
const SMALL := 480.0
const NARROWEST_STEP_ON_SMALL := 12.0
## Nor does [method fit] make it wider than this, in pixels, unless a lesson says so.
const WIDEST_STEP := 40.0
## Grid steps are these times a power of ten.
const STEP_FACTORS: Array[float] = [1.0, 2.0, 5.0]

# The margin takes at most this share of a small board.
const _WIDEST_MARGIN := 0.12

## The widest step of the grid; more where a lesson draws short vectors.
@export_range(24.0, 200.0, 1.0, "suffix:px") var widest_step := WIDEST_STEP
## Pixels that [method fit] leaves free along every edge; less on a small board.
@export_range(8.0, 100.0, 1.0, "suffix:px") var margin := 56.0
## Units to which handles snap and by which keys nudge; 0 for the step of the grid.
@export_range(0.0, 100.0, 0.001, "or_greater") var snap_step := 0.0

## What [method fit] keeps in the middle: the origin, or, where false, the middle of the points.
@export var keeps_origin := true

## Pixels of the screen per unit of the plane.
var pixels_per_unit := 40.0

## Draws its own background; false where a [Grid] lies on it, which draws the same.
var has_paper := true:
	set(value):
		has_paper = value
		queue_redraw()

## Units between two lines of the grid: 1, 2 or 5 times 10^n.
var grid_step := 1.0

## False: y points down, as on the screen and in the course. True: y points up, as in mathematics.
## The plane and all numbers stay; only the picture is turned over.
var is_y_up := false:
	set(value):
		if value != is_y_up:
			is_y_up = value
			view_changed.emit()

var _middle := Vec2.new()
# The strips at the upper and the lower edge that cards cover.
var _covered := Vector2.ZERO
# What the view was fitted to.
var _fitted: Array[Vec2] = []
# What the parts of the board span: the editor's view is fitted to it.
var _spanned: Array[Vec2] = []
var _pressed_button := MOUSE_BUTTON_NONE


func _ready() -> void:
	# The editor would save what is set here.
	if Engine.is_editor_hint():
		return
	clip_contents = true
	if focus_mode == FOCUS_NONE:
		focus_mode = FOCUS_CLICK
	focus_entered.connect(_pass_focus_on)
	resized.connect(view_changed.emit)


func _draw() -> void:
	if has_paper:
		draw_rect(Rect2(Vector2.ZERO, size), Palette.drawn(Palette.PAPER))


## Where [param point] of the plane is on the board, in the board's own pixels. Points far outside
## stay finite: they are brought to a distance at which 32-bit drawing still knows the direction.
func to_screen(point: Vec2) -> Vector2:
	var limit := 1e6
	var from_middle := point.minus(_middle).scaled(pixels_per_unit)
	if not from_middle.is_finite():
		return Vector2(limit, limit)
	from_middle.limit_length(limit)
	from_middle.y *= y_sign()
	return from_middle.to_vector2() + _middle_pixel()


## Which point of the plane is at [param pixel] of the board.
func to_plane(pixel: Vector2) -> Vec2:
	var point := Vec2.from_vector2(pixel - _middle_pixel())
	point.scale(1.0 / pixels_per_unit)
	point.y *= y_sign()
	point.add(_middle)
	return point


## How [param direction] of the plane lies on the screen, with its length.
func direction_to_screen(direction: Vec2) -> Vector2:
	return Vector2(direction.x, direction.y * y_sign())


## Turns the picture over, or back: [member is_y_up] as the student has chosen.
func turn_over(y_is_up: bool) -> void:
	is_y_up = y_is_up


## 1 where y points down the screen, -1 where it points up. Angles of the plane are seen on the
## screen with this sign.
func y_sign() -> float:
	return -1.0 if is_y_up else 1.0


## Units between two points to which handles snap.
func step_length() -> float:
	return snap_step if snap_step > 0.0 else grid_step


## The point to which a handle at [param point] snaps.
func snapped_to_step(point: Vec2) -> Vec2:
	var step := step_length()
	return Vec2.new(roundf(point.x / step) * step, roundf(point.y / step) * step)


## Chooses scale and grid so that all [param points] are well inside. The origin is in the middle,
## where the board [member keeps_origin]. The step is below 1 only if all points are within 1 of the
## middle, so that handles snap to whole units.
func fit(points: Array[Vec2]) -> void:
	_fitted = points
	_middle = Vec2.new() if keeps_origin else _middle_of(points)
	var reach_x := 0.0
	var reach_y := 0.0
	for point in points:
		reach_x = maxf(reach_x, absf(point.x - _middle.x))
		reach_y = maxf(reach_y, absf(point.y - _middle.y))
	var half := (size - Vector2(0.0, _covered.x + _covered.y)) / 2.0
	var edge := minf(margin, minf(size.x, size.y) * _WIDEST_MARGIN) if is_small() else margin
	var room := (half - Vector2(edge, edge)).max(Vector2(40.0, 40.0).min(half * 0.8))
	var narrowest_step := NARROWEST_STEP_ON_SMALL if is_small() else NARROWEST_STEP
	var narrowest_unit := minf(room.x / maxf(reach_x, 1e-300), room.y / maxf(reach_y, 1e-300))
	var is_tiny := maxf(reach_x, reach_y) < 1.0 and maxf(reach_x, reach_y) > 0.0
	grid_step = maxf(_next_step(narrowest_step / narrowest_unit), 0.0 if is_tiny else 1.0)
	pixels_per_unit = minf(widest_step / grid_step, narrowest_unit)
	queue_redraw()
	view_changed.emit()


## Whether there is so little room that steps of the grid may be narrower, and that cards lie in the
## panel.
func is_small() -> bool:
	return minf(size.x, size.y) < SMALL


## Leaves strips of so many pixels free at the upper and the lower edge, which cards cover: the
## middle of the view is between them.
func keep_free(above: float, below: float) -> void:
	if _covered != Vector2(above, below):
		_covered = Vector2(above, below)
		fit(_fitted)


## Fits the view of the editor to [param points] as well: there no lesson runs that would call
## [method fit].
func span(points: Array[Vec2]) -> void:
	if Engine.is_editor_hint():
		_spanned.append_array(points)
		fit(_spanned)


## The handles that can be seen on this board and on boards that lie on it, in the order of the
## tree.
func handles() -> Array[Control]:
	var found: Array[Control] = []
	for node: Node in get_tree().get_nodes_in_group(HANDLES):
		if is_ancestor_of(node) and (node as Control).is_visible_in_tree():
			found.append(node as Control)
	return found


## Of these the ones that take the focus, in the order in which the Tab key reaches them.
func focusable_handles() -> Array[Control]:
	return handles().filter(func(handle: Control) -> bool: return handle.focus_mode != FOCUS_NONE)


## The part of the board that no strip of [method keep_free] covers, in pixels.
func free_area() -> Rect2:
	return Rect2(0.0, _covered.x, size.x, size.y - _covered.x - _covered.y)


# Where the middle of the view is.
func _middle_pixel() -> Vector2:
	return free_area().get_center()


# After a click the board keeps the focus. Tab and gamepad go on to the first handle, or backwards
# to the last.
func _pass_focus_on() -> void:
	var all := focusable_handles()
	if all.is_empty() or Input.get_mouse_button_mask() != 0:
		return
	all[-1 if Input.is_action_pressed(&"ui_focus_prev") else 0].grab_focus()


func _gui_input(event: InputEvent) -> void:
	var click := event as InputEventMouseButton
	var motion := event as InputEventMouseMotion
	if click and click.pressed and click.button_index in [MOUSE_BUTTON_LEFT, MOUSE_BUTTON_RIGHT]:
		end_drag()
		_pressed_button = click.button_index
		pointed.emit(to_plane(click.position), _pressed_button)
		accept_event()
	elif click and click.button_index == _pressed_button:
		end_drag()
	elif motion and _pressed_button != MOUSE_BUTTON_NONE:
		# The button may have been released where nobody saw it, as outside of the window.
		if motion.button_mask & (1 << (_pressed_button - 1)):
			pointed.emit(to_plane(motion.position), _pressed_button)
		else:
			end_drag()


## Ends a click or drag on the empty board; does nothing where there is none.
func end_drag() -> void:
	if _pressed_button != MOUSE_BUTTON_NONE:
		_pressed_button = MOUSE_BUTTON_NONE
		released.emit()


# The middle of the upright box around these points; the origin where there are none.
static func _middle_of(points: Array[Vec2]) -> Vec2:
	if points.is_empty():
		return Vec2.new()
	var low := points[0].copy()
	var high := points[0].copy()
	for point in points:
		low.set_xy(minf(low.x, point.x), minf(low.y, point.y))
		high.set_xy(maxf(high.x, point.x), maxf(high.y, point.y))
	return low.lerped(high, 0.5)


# The smallest 1, 2 or 5 times 10^n that is not below `least`.
static func _next_step(least: float) -> float:
	var power := pow(10.0, floorf(log(least) / log(10.0) - 1e-9))
	for factor in STEP_FACTORS:
		if factor * power >= least * (1.0 - 1e-9):
			return factor * power
	return 10.0 * power
