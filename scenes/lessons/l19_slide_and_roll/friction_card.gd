@tool
class_name FrictionCard
extends Control
## The friction µ on an axis, on which it can be dragged. A [FrictionCurve] on it shows from where
## on the ball rolls.

## The student pointed at this µ.
signal friction_pointed(friction: float)
## The click or drag that [signal friction_pointed] told of has ended.
signal released

## Between the card's edges and the axis, in pixels.
const MARGIN_SIDE := 24.0
const MARGIN_BOTTOM := 34.0
const MARGIN_TOP := 34.0
const FONT_SIZE := 15
# A µ that is dragged is a multiple of this.
const _STEP := 0.005
const _KNOB := 9.0
# A number at an end of the axis needs so much of it free.
const _ROOM_OF_MARK := 0.17
# The axis ends at one of these times a power of ten.
const _ENDS: PackedFloat64Array = [1.0, 1.5, 2.0, 3.0, 5.0, 7.5, 10.0]

## The right end of the axis.
var most := 1.0

var _friction := 0.0
var _mark := 0.0
var _is_dragged := false


func _ready() -> void:
	resized.connect(queue_redraw)
	# The editor would save it.
	if not Engine.is_editor_hint():
		accessibility_name = tr("Friction µ")
		mouse_default_cursor_shape = CURSOR_HSIZE


## Shows [param friction], on an axis on which there is room for the names of [param mark] and of
## [param farthest], too. During a drag the axis stays.
func show_friction(friction: float, mark: float, farthest: float) -> void:
	_friction = friction
	_mark = mark
	if not _is_dragged:
		most = _end_for(1.2 * maxf(friction, maxf(mark, farthest)))
	queue_redraw()


# At least 0.5 or so: a short axis makes small numbers look large.
static func _end_for(least: float) -> float:
	if least <= 0.5:
		return 0.5
	var power := 10.0 ** floorf(log(least) / log(10.0))
	for factor in _ENDS:
		if factor * power >= least:
			return factor * power
	return 10.0 * power


## Where [param friction] is on the axis, in pixels from the left.
func pixel_of(friction: float) -> float:
	return MARGIN_SIDE + friction / most * (size.x - 2.0 * MARGIN_SIDE)


func _draw() -> void:
	draw_style_box(get_theme_stylebox(&"panel", &"PanelCard"), Rect2(Vector2.ZERO, size))
	var foot := size.y - MARGIN_BOTTOM
	var axis := Palette.drawn(Palette.AXIS)
	draw_line(Vector2(pixel_of(0.0), foot), Vector2(pixel_of(most), foot), axis, 2.0)
	for end: float in [0.0, most]:
		var x := pixel_of(end)
		draw_line(Vector2(x, foot), Vector2(x, foot + 5.0), axis, 2.0)
		# The name of a mark needs the room.
		if absf(_mark - end) >= _ROOM_OF_MARK * most:
			_write(NumberText.short(end), x, size.y - 10.0, Palette.Role.QUIET)
	var knob := Vector2(pixel_of(_friction), foot)
	var color := Palette.color(Palette.Role.REST)
	draw_texture(_dot(), knob - _dot().get_size() / 2.0)
	draw_line(knob, Vector2(knob.x, MARGIN_TOP), Color(color, 0.5), Palette.stroke(1.5))
	_write("µ = %s" % NumberText.short(_friction), knob.x, MARGIN_TOP - 12.0, Palette.Role.REST)


func _dot() -> Texture2D:
	return DotTexture.of(Palette.drawn(Palette.PAPER), Palette.color(Palette.Role.REST), _KNOB)


# A text with its middle at `x`, inside the card.
func _write(text: String, x: float, y: float, role: Palette.Role) -> void:
	var font := get_theme_default_font()
	var width := font.get_string_size(text, HORIZONTAL_ALIGNMENT_LEFT, -1, FONT_SIZE).x
	var left := clampf(x - width / 2.0, 6.0, size.x - width - 6.0)
	var at := Vector2(left, y)
	draw_string(font, at, text, HORIZONTAL_ALIGNMENT_LEFT, -1, FONT_SIZE, Palette.color(role))


func _gui_input(event: InputEvent) -> void:
	var click := event as InputEventMouseButton
	var motion := event as InputEventMouseMotion
	if click and click.button_index == MOUSE_BUTTON_LEFT:
		end_drag()
		if click.pressed:
			_is_dragged = true
			friction_pointed.emit(_friction_at(click.position.x))
		accept_event()
	elif motion and _is_dragged:
		# The button may have been released where nobody saw it, as outside of the window.
		if motion.button_mask & MOUSE_BUTTON_MASK_LEFT:
			friction_pointed.emit(_friction_at(motion.position.x))
		else:
			end_drag()
		accept_event()


## Ends a click or drag on the axis; does nothing where there is none.
func end_drag() -> void:
	if _is_dragged:
		_is_dragged = false
		released.emit()


func _friction_at(pixel: float) -> float:
	var share := (pixel - MARGIN_SIDE) / (size.x - 2.0 * MARGIN_SIDE)
	return snappedf(clampf(share, 0.0, 1.0) * most, _STEP)
