@tool
class_name MomentaBoard
extends Board
## The momenta of two balls tip to tail: above before the bounce, below after it. The sum is the
## same arrow.

# Arrows that lie nearly along each other are drawn side by side, so far apart as a share of the
# widest one.
const _LANE := 0.12
# Two arrows with less than this between them, as a share of the widest one, lie along each other.
const _FLAT := 0.15
# Half of the width that is shown, as a share of that of the arrows: their names stand beside them.
const _ROOM := 0.66
# Between both pictures.
const _GAP := 0.16

var _points: Array[Vec2] = []

@onready var _before: Array[Arrow] = [%P1, %P2, %P]
@onready var _after: Array[Arrow] = [%P1After, %P2After, %PAfter]


func _ready() -> void:
	super()
	if not Engine.is_editor_hint():
		resized.connect(func() -> void: fit(_points))


## Shows the momenta of ball 1 and ball 2 before and after the bounce.
func show_momenta(before: Array[Vec2], after: Array[Vec2]) -> void:
	var widest := 1e-300
	for momentum: Vec2 in before + after + [before[0].plus(before[1])]:
		widest = maxf(widest, momentum.length())
	var above := _chain(before, widest)
	var below := _chain(after, widest)
	var room_above := _bounds(above)
	var room_below := _bounds(below)
	var left := minf(room_above[0].x, room_below[0].x)
	var right := maxf(room_above[1].x, room_below[1].x)
	var gap := _GAP * widest
	var height := room_above[1].y - room_above[0].y + gap + room_below[1].y - room_below[0].y
	var middle := -(left + right) / 2.0
	_lay(_before, above, Vec2.new(middle, -height / 2.0 - room_above[0].y))
	_lay(_after, below, Vec2.new(middle, height / 2.0 - room_below[1].y))
	_points = [
		Vec2.new((right - left) * _ROOM, height / 2.0),
		Vec2.new((left - right) * _ROOM, -height / 2.0)
	]
	fit(_points)


# Tails and heads of the two momenta and of their sum, one after the other.
static func _chain(momenta: Array[Vec2], widest: float) -> Array[Vec2]:
	var sum := momenta[0].plus(momenta[1])
	var points: Array[Vec2] = [
		Vec2.new(), momenta[0].copy(), momenta[0].copy(), sum.copy(), Vec2.new(), sum.copy()
	]
	if absf(momenta[0].cross(momenta[1])) < _FLAT * widest * widest:
		var longest := momenta[0] if momenta[0].length() > momenta[1].length() else momenta[1]
		var side := longest.normal()
		if side.y < 0.0:
			side = side.negated()
		for place: int in points.size():
			points[place].add(side.scaled(floorf(place / 2.0) * _LANE * widest))
	return points


# The corners with the lowest and the highest coordinates.
static func _bounds(points: Array[Vec2]) -> Array[Vec2]:
	var low := points[0].copy()
	var high := points[0].copy()
	for point in points:
		low.set_xy(minf(low.x, point.x), minf(low.y, point.y))
		high.set_xy(maxf(high.x, point.x), maxf(high.y, point.y))
	return [low, high]


static func _lay(arrows: Array[Arrow], points: Array[Vec2], moved: Vec2) -> void:
	for place: int in arrows.size():
		arrows[place].lay(points[2 * place].plus(moved), points[2 * place + 1].plus(moved))
