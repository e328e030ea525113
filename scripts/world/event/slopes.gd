class_name Slopes
extends RefCounted
## The segments and walls of an [EventWorld] as lines on which balls slide and roll: for each an
## [Incline], made when a ball first lies on it.

## The surfaces that are no segments, whose places are 0 or more.
enum { LEFT_WALL = -5, RIGHT_WALL = -4, TOP_WALL = -3, BOTTOM_WALL = -2 }

var _segments: SegmentScan
# The corners of the walls.
var _low: Vec2
var _high: Vec2
# px/s².
var _gravity: Vec2
# µ.
var _friction := 0.0
var _inclines: Dictionary[int, Incline] = {}


## Takes these segments, the corners of the walls, this gravity in px/s² and this µ; what has been
## made so far is forgotten.
func set_up(segments: SegmentScan, low: Vec2, high: Vec2, gravity: Vec2, friction: float) -> void:
	_segments = segments
	_low = low
	_high = high
	_gravity = gravity
	_friction = friction
	_inclines.clear()


## The line of this surface, a segment or a wall.
func at(surface: int) -> Incline:
	var found: Incline = _inclines.get(surface)
	if not found:
		var belt: float = _segments.belts.get(surface, 0.0)
		found = Incline.new(_line_of(surface), _gravity, _friction, belt)
		_inclines[surface] = found
	return found


func _line_of(surface: int) -> LineSegment:
	if surface >= 0:
		return _segments.segment(surface)
	var from := _low.copy()
	var to := _high.copy()
	match surface:
		LEFT_WALL:
			to.x = from.x
		RIGHT_WALL:
			from.x = to.x
		TOP_WALL:
			to.y = from.y
		BOTTOM_WALL:
			from.y = to.y
	return LineSegment.new(from, to)
