@tool
class_name MomentaBoard
extends Board
## The momenta of two balls tip to tail: on the left before the bounce, on the right after it. The
## sum is the same arrow.

# Arrows that lie nearly along each other are drawn side by side, so far apart as a share of the
# longest one.
const _LANE := 0.24
# Two arrows with less than this between them, as a share of the longest one, lie along each other.
const _FLAT := 0.15
# Between both pictures, and beside them: names stand there.
const _BETWEEN := 1.1
const _BESIDE := 0.4

var _points: Array[Vec2] = []

@onready var _before: Array[Arrow] = [%P1, %P2, %P]
@onready var _after: Array[Arrow] = [%P1After, %P2After, %PAfter]


func _ready() -> void:
	super()
	if not Engine.is_editor_hint():
		resized.connect(func() -> void: fit(_points))


## Shows the momenta of ball 1 and ball 2 before and after the bounce.
func show_momenta(before: Array[Vec2], after: Array[Vec2]) -> void:
	var longest := 1e-300
	for momentum: Vec2 in before + after + [before[0].plus(before[1])]:
		longest = maxf(longest, momentum.length())
	var gap := _BETWEEN * longest
	var left := _chain(before, longest)
	var right := _chain(after, longest)
	var room_left := _bounds(left)
	var room_right := _bounds(right)
	var width := room_left[1].x - room_left[0].x + gap + room_right[1].x - room_right[0].x
	var low := minf(room_left[0].y, room_right[0].y)
	var high := maxf(room_left[1].y, room_right[1].y)
	var up := -(low + high) / 2.0
	_lay(_before, left, Vec2.new(-width / 2.0 - room_left[0].x, up))
	_lay(_after, right, Vec2.new(width / 2.0 - room_right[1].x, up))
	_points = [Vec2.new(width / 2.0 + _BESIDE * longest, (high - low) / 2.0)]
	fit(_points)


# Tails and heads of the two momenta and of their sum, one after the other.
static func _chain(momenta: Array[Vec2], longest: float) -> Array[Vec2]:
	var sum := momenta[0].plus(momenta[1])
	var points: Array[Vec2] = [
		Vec2.new(), momenta[0].copy(), momenta[0].copy(), sum.copy(), Vec2.new(), sum.copy()
	]
	if absf(momenta[0].cross(momenta[1])) < _FLAT * longest * longest:
		var along := momenta[0] if momenta[0].length() > momenta[1].length() else momenta[1]
		var side := along.normal()
		if side.y < 0.0:
			side = side.negated()
		for place: int in points.size():
			points[place].add(side.scaled(floorf(place / 2.0) * _LANE * longest))
	return points


# The corners with the lowest and the highest coordinates.
static func _bounds(points: Array[Vec2]) -> Array[Vec2]:
	var low := points[0].copy()
	var high := points[0].copy()
	for point in points:
		low.set_xy(minf(low.x, point.x), minf(low.y, point.y))
		high.set_xy(maxf(high.x, point.x), maxf(high.y, point.y))
	return [low, high]


# In a triangle the names stand outside of it, else behind the tips.
static func _lay(arrows: Array[Arrow], points: Array[Vec2], moved: Vec2) -> void:
	var is_triangle := points[0].distance_to(points[4]) == 0.0
	var middle := points[0].plus(points[1]).plus(points[5]).divided(3.0).plus(moved)
	for place: int in arrows.size():
		arrows[place].label_place = (
			Arrow.LabelPlace.MIDDLE if is_triangle else Arrow.LabelPlace.HEAD
		)
		arrows[place].keep_label_from(middle)
		arrows[place].lay(points[2 * place].plus(moved), points[2 * place + 1].plus(moved))
