@tool
class_name LightRays
extends BoardPart
## Parallel rays of light that fall straight onto a line, and the shadow of what stands in their
## way.

## The word beside the light: source text.
const _WORD := "light"
# All in pixels.
const _APART := 26.0
const _ABOVE := 76.0
const _BEYOND := 2
const _TIP := 9.0
const _MOST_RAYS := 60

## Its color, here as pale as light.
@export var role := Palette.Role.UNIT

var _from := Vec2.new()
var _to := Vec2.new()
var _along := Vec2.new()
var _point := Vec2.new()


## Lets light fall onto the line through [param point] along [param along], from the side where the
## arrow from [param from] to [param to] is; all in units of the plane.
func lay(from: Vec2, to: Vec2, point: Vec2, along: Vec2) -> void:
	_from = from.copy()
	_to = to.copy()
	_point = point.copy()
	_along = along.copy()
	show_change()


func spanned_points() -> Array[Vec2]:
	return [_from, _to]


# In a frame of its own: x along the line, y from the line towards the light.
func _draw() -> void:
	var origin := board.to_screen(_point)
	var axis := origin.direction_to(board.to_screen(_point.plus(_along)))
	if axis == Vector2.ZERO:
		return
	var to_light := axis.orthogonal()
	if to_light.dot(board.to_screen(_to) - origin) < 0.0:
		to_light = -to_light
	var frame := Transform2D(axis, to_light, origin)
	var tail := frame.affine_inverse() * board.to_screen(_from)
	var head := frame.affine_inverse() * board.to_screen(_to)
	var shadow: PackedVector2Array = [tail, head, Vector2(head.x, 0.0), Vector2(tail.x, 0.0)]
	draw_primitive(frame * shadow.slice(0, 3), [_pale(0.12)], [])
	draw_primitive(frame * PackedVector2Array([tail, shadow[2], shadow[3]]), [_pale(0.12)], [])
	_draw_rays(frame, tail, head)


func _draw_rays(frame: Transform2D, tail: Vector2, head: Vector2) -> void:
	var top := maxf(maxf(tail.y, head.y), 0.0) + _ABOVE
	var first := floori(minf(tail.x, head.x) / _APART) - _BEYOND
	var last := ceili(maxf(tail.x, head.x) / _APART) + _BEYOND
	if last - first > _MOST_RAYS:
		return
	for i in range(first, last + 1):
		var x := (i + 0.5) * _APART
		var share := inverse_lerp(tail.x, head.x, x) if tail.x != head.x else -1.0
		var is_caught := share >= 0.0 and share <= 1.0
		var foot := maxf(lerpf(tail.y, head.y, share), 0.0) if is_caught else 0.0
		_draw_ray(frame * Vector2(x, top), frame * Vector2(x, foot))
	var word := frame * Vector2((tail.x + head.x) / 2.0, top + 20.0)
	draw_text(tr(_WORD), word, Palette.color(Palette.Role.QUIET), 18)


func _draw_ray(from: Vector2, to: Vector2) -> void:
	var back := to.direction_to(from) * _TIP
	var side := back.orthogonal() * 0.45
	draw_line(from, to + back, _pale(0.4), 1.5, true)
	var corners: PackedVector2Array = [to, to + back + side, to + back - side]
	draw_primitive(corners, [_pale(0.55)], [])


func _pale(share: float) -> Color:
	return Color(Palette.color(role), share)
