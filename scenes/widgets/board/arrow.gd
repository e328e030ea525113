@tool
class_name Arrow
extends BoardPart
## An arrow between two points of the plane, with a label; solid or dashed.

## Where along the arrow its label is.
enum LabelPlace { HEAD, MIDDLE }

## A head shorter than this, in pixels, is not drawn: the arrow is then a dot.
const SHORTEST := 2.0

const _FONT_SIZE := 24

## Where it begins, in units of the plane. 32 bits; [method lay] keeps all digits.
@export var tail := Vector2.ZERO:
	get:
		return _tail.to_vector2()
	set(value):
		lay(Vec2.from_vector2(value), _head)
## Where it ends, in units of the plane.
@export var head := Vector2.ZERO:
	get:
		return _head.to_vector2()
	set(value):
		lay(_tail, Vec2.from_vector2(value))
## The label beside the arrow, such as `a`; nothing where it is empty. A name in code is not
## translated: its arrow has the auto translate mode Disabled.
@export var label := "":
	set(value):
		label = value
		queue_redraw()
## Which color it has, here and in formulas.
@export var role := Palette.Role.INK
## Thickness of the shaft in pixels.
@export_range(1.0, 12.0, 0.5, "suffix:px") var width := 5.0
## Dashed: a leftover or a helping line.
@export var dashed := false
## False draws a line without a tip.
@export var has_tip := true
## Beyond the head, or beside the middle on the side that [method keep_label_from] leaves.
@export var label_place := LabelPlace.HEAD
## Where a label beside the arrow is on the way from the tail to the head.
@export_range(0.0, 1.0, 0.05) var label_share := 0.5

## Whether it is lit up; see [method light].
var lit := false:
	set(value):
		lit = value
		queue_redraw()

var _tail := Vec2.new()
var _head := Vec2.new()
var _crowded := Vec2.new()


## Lays the arrow from one point to another, both in units of the plane.
func lay(from: Vec2, to: Vec2) -> void:
	_tail = from.copy()
	_head = to.copy()
	show_change()


func spanned_points() -> Array[Vec2]:
	return [_tail, _head]


## Lights up when [param its_role] is the arrow's own: its symbol in a formula is pointed at.
func light(its_role: Palette.Role) -> void:
	lit = its_role == role and role != Palette.Role.INK


## Puts a label beside the middle on the side away from [param point], where other things are drawn.
func keep_label_from(point: Vec2) -> void:
	_crowded = point.copy()
	queue_redraw()


## Where the middle of its label is, in the board's pixels.
func label_pixel() -> Vector2:
	return _label_middle(board.to_screen(_tail), board.to_screen(_head))


func _draw() -> void:
	var from := board.to_screen(_tail)
	var to := board.to_screen(_head)
	var color := Palette.color(role)
	var length := from.distance_to(to)
	if lit:
		draw_line(from, to, Color(color, 0.25), width * 3.0, true)
	if length < SHORTEST:
		draw_circle(from, width, color, true, -1.0, true)
	else:
		_draw_shaft(from, to, color)
	if label:
		draw_text(atr(label), _label_middle(from, to), color, _FONT_SIZE)


func _draw_shaft(from: Vector2, to: Vector2, color: Color) -> void:
	var direction := from.direction_to(to)
	var stroke := Palette.stroke(width)
	var tip_length := minf(3.6 * stroke, from.distance_to(to)) if has_tip else 0.0
	var neck := to - direction * tip_length
	if dashed:
		draw_strokes(from, neck, color, width)
	else:
		draw_line(from, neck + direction, color, stroke, true)
	if has_tip:
		var side := direction.orthogonal() * tip_length * 0.45
		# Not as a polygon: far outside the board the engine cannot triangulate one.
		var corners: PackedVector2Array = [to, neck + side, neck - side]
		draw_primitive(corners, [color], [])


func _label_middle(from: Vector2, to: Vector2) -> Vector2:
	var direction := from.direction_to(to) if from.distance_to(to) > SHORTEST else Vector2.RIGHT
	var extent := text_extent(atr(label), _FONT_SIZE)
	var middle := to + direction * (_reach(extent, direction) + 6.0)
	if not has_tip:
		# The line may go on beyond its end: its label lies above it.
		var above := direction.orthogonal()
		above *= -signf(above.y + 1e-9)
		middle = to + above * _reach(extent, above)
	if label_place == LabelPlace.MIDDLE:
		var side := direction.orthogonal()
		if side.dot(board.to_screen(_crowded) - from) > 0.0:
			side = -side
		middle = from.lerp(to, label_share) + side * _reach(extent, side)
	return kept_on_board(middle, Vector2(extent.x, 0.0), Vector2(8.0, 22.0))


# How far from the line the middle of a text is, so that it lies beside the line.
static func _reach(extent: Vector2, direction: Vector2) -> float:
	return 12.0 + (absf(direction.x) * extent.x + absf(direction.y) * 0.72 * extent.y) / 2.0
