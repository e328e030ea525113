class_name PushOut
extends RefCounted
## Pushes a ball out of the lines and walls that it overlaps after something has been changed: the
## shortest way, to the side where its centre is. It is the one rule of overlap of all worlds: what
## rests stays above, what is pushed into is pushed out.
##
## Out of one line that is one step along the normal. Where this leads into another one, the ball
## slides along the first until it touches both. A ball between lines that are nearer to each other
## than its diameter fits nowhere: it is left where it overlaps least.

# A ball in a corner is out after two rounds; the others are for three lines and more.
const _ROUNDS := 24
# Normals that enclose less than this, in radians, count as one.
const _LEAST_ANGLE := 1e-9

var _radius: float
var _slack: float
var _lines: Array[LineSegment] = []
# For each line the side on which the ball belongs: 1 where its normal points, else -1.
var _sides: PackedFloat64Array = []
var _has_walls := false
var _low: Vec2
var _high: Vec2
# Where the ball is pushed to, and what overlaps most there: its normal, the depth in pixels, and
# the point where it is round; null where it is straight.
var _at: Vec2
var _normal: Vec2
var _depth := 0.0
var _point: Vec2


## Begins with a ball whose centre is at [param start]. What it overlaps by no more than
## [param slack], in pixels, is left as it is.
func _init(start: Vec2, radius: float, slack: float) -> void:
	_at = start.copy()
	_radius = radius
	_slack = slack


## Adds a line that the ball must not overlap. [param side] is the side on which the ball belongs,
## 1 where the line's normal points and -1 on the other; 0 is the side where the ball is now.
func add_line(line: LineSegment, side: float = 0.0) -> void:
	_lines.append(line)
	_sides.append(side if side != 0.0 else side_of(line, _at))


## Keeps the ball inside the box between two corners, the upper left and the lower right.
func add_walls(low: Vec2, high: Vec2) -> void:
	_has_walls = true
	_low = low
	_high = high


## Where the ball is when it has been pushed out.
func position() -> Vec2:
	_push()
	if _depth > _slack:
		# A moved line may have carried the ball over another one: that counts where it is now.
		for index in _lines.size():
			_sides[index] = side_of(_lines[index], _at)
		_push()
	return _at


# Moves the ball out of everything, or to where it overlaps least.
func _push() -> void:
	_find_deepest()
	var best := _at.copy()
	var least := _depth
	var last: Vec2 = null
	for round_number in _ROUNDS:
		if _depth <= _slack:
			return
		var way := _way_out(last)
		last = _normal.copy()
		_at.add(way)
		_find_deepest()
		if _depth < least:
			least = _depth
			best = _at.copy()
	_at = best
	_find_deepest()


## The side of a line on which a point is: 1 where the line's normal points, else -1.
static func side_of(line: LineSegment, point: Vec2) -> float:
	return 1.0 if point.minus(line.start).dot(line.normal()) >= 0.0 else -1.0


## The same for a point that is no farther than [param reach] pixels from the line and between its
## ends; 0 for any other.
static func side_touched(line: LineSegment, point: Vec2, reach: float) -> float:
	var share := line.share_of(point)
	if share < 0.0 or share > 1.0 or line.closest_point(point).distance_to(point) > reach:
		return 0.0
	return side_of(line, point)


## The side of a moved line that was the side [param side] of the old one.
static func side_after(side: float, old: LineSegment, moved: LineSegment) -> float:
	return -side if old.along().dot(moved.along()) < 0.0 else side


# Out of what overlaps most, along its normal. If the ball has been pushed out of something with the
# unit normal `last` just before, it slides along that instead.
func _way_out(last: Vec2) -> Vec2:
	if not last:
		return _normal.scaled(_depth)
	var along := _normal.rejection(last)
	var gain := along.length_squared()
	if gain < _LEAST_ANGLE * _LEAST_ANGLE:
		return _normal.scaled(_depth)
	if not _point:
		return along.scaled(_depth / gain)
	along.normalize()
	var away := _at.minus(_point)
	var nearest := -along.dot(away)
	var half := sqrt(_radius * _radius - away.cross(along) ** 2)
	return along.scaled(nearest + half)


func _find_deepest() -> void:
	_depth = -INF
	for index in _lines.size():
		_look_at_line(_lines[index], _sides[index])
	if _has_walls:
		_take(Vec2.new(1.0, 0.0), _low.x + _radius - _at.x)
		_take(Vec2.new(-1.0, 0.0), _at.x + _radius - _high.x)
		_take(Vec2.new(0.0, 1.0), _low.y + _radius - _at.y)
		_take(Vec2.new(0.0, -1.0), _at.y + _radius - _high.y)


func _look_at_line(line: LineSegment, side: float) -> void:
	var share := line.share_of(_at)
	if share >= 0.0 and share <= 1.0:
		var normal := line.normal().scaled(side)
		_take(normal, _radius - _at.minus(line.start).dot(normal))
		return
	var point := line.start if share < 0.0 else line.end
	var away := _at.minus(point)
	_take(away.normalized(), _radius - away.length(), point)


func _take(normal: Vec2, depth: float, point: Vec2 = null) -> void:
	if depth > _depth:
		_depth = depth
		_normal = normal
		_point = point
