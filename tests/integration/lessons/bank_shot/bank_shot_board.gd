extends RefCounted
## A board of the lesson on bank shots, worked out by plain formulas for its judge: what becomes of
## each order of walls, and how far the shot of a mistake misses.

enum Found { HIT, NONE, BEHIND, NOT_REACHED, BESIDE, BLOCKED }

## Where less than this share of the board decides, both may be said.
const SLACK := 1e-9
# A shot that bounces more often may be too sensitive to be flown again.
const _MOST_BOUNCES := 3
# Shots are followed for this many times the way of the right one.
const _TIMES_FOLLOWED := 1.5

const _RADIUS_FORGOTTEN := 101
const _MIDPOINT := 102
const _PLAIN_MIRROR := 103
const _WRONG_ORDER := 104

var start: Point
var target: Point
var radius: float
var bounciness: float
var count: int
var order: String
var mistake: int
var walls: Array[PackedFloat64Array] = []
## The largest number of the board.
var size: float
## Something of this board hangs on rounding.
var is_close: bool
## The best way for each order.
var ways: Dictionary[String, Way] = {}
var way: Way


## What becomes of one order of walls.
class Way:
	extends RefCounted
	var found := Found.NONE
	## The wall at which it fails, by its place.
	var at := -1
	var distance := INF
	var order := ""
	var sides: PackedFloat64Array = []
	var images: Array[Point] = []
	var bounces := 0


## Two numbers in 64 bits.
class Point:
	extends RefCounted
	var x: float
	var y: float

	func _init(its_x: float, its_y: float) -> void:
		x = its_x
		y = its_y

	func to(other: Point, times: float = 1.0) -> Point:
		return Point.new(times * (other.x - x), times * (other.y - y))

	func plus(other: Point, times: float = 1.0) -> Point:
		return Point.new(x + times * other.x, y + times * other.y)

	func dot(other: Point) -> float:
		return x * other.x + y * other.y

	func length() -> float:
		return sqrt(x * x + y * y)


func _init(state: Dictionary) -> void:
	var of_start: PackedFloat64Array = state["start"]
	var of_target: PackedFloat64Array = state["target"]
	var of_walls: Array = state["walls"]
	start = _point(of_start, 0)
	target = _point(of_target, 0)
	radius = state["radius"]
	bounciness = state["bounciness"]
	count = state["bounces"]
	order = state["order"]
	mistake = state["mistake"]
	walls.assign(of_walls)
	size = radius + absf(start.x) + absf(start.y) + absf(target.x) + absf(target.y)
	for wall in walls:
		for number in wall:
			size = maxf(size, absf(number))
	size /= bounciness ** count
	_find_ways()


static func _point(numbers: PackedFloat64Array, at: int) -> Point:
	return Point.new(numbers[at], numbers[at + 1])


# Whether a number is above 0; one near 0 makes this board undecided.
func _is_above(number: float) -> bool:
	is_close = is_close or absf(number) < SLACK * size
	return number > 0.0


func _normal(wall: int, side: float) -> Point:
	var along := _point(walls[wall], 0).to(_point(walls[wall], 2))
	var length := along.length()
	return Point.new(-side * along.y / length, side * along.x / length)


func height(point: Point, wall: int, side: float) -> float:
	return _normal(wall, side).dot(_point(walls[wall], 0).to(point))


func _find_ways() -> void:
	ways.clear()
	for walked in _orders(count):
		var best := Way.new()
		best.at = int(walked[0]) - 1
		for number in 1 << count:
			var sides: PackedFloat64Array = []
			for place in count:
				sides.append(-1.0 if number & (1 << place) else 1.0)
			if _fit(walked, sides):
				var tried := _followed(walked, sides)
				if _rank(tried) > _rank(best):
					best = tried
		ways[walked] = best
	way = ways.values()[0]
	for walked in ways:
		var is_better := _rank(ways[walked]) > _rank(way)
		var is_shorter := ways[walked].distance < way.distance
		if walked == order or not order and (is_better or is_hit(ways[walked]) and is_shorter):
			way = ways[walked]
	if order:
		way = ways[order]


func _orders(length: int) -> PackedStringArray:
	if length == 0:
		return [""]
	var found: PackedStringArray = []
	for shorter in _orders(length - 1):
		for wall in walls.size():
			if not shorter.ends_with(str(wall + 1)):
				found.append(shorter + str(wall + 1))
	return found


# The first wall is met on the side of the start, the last one on that of the target.
func _fit(walked: String, sides: PackedFloat64Array) -> bool:
	var first := height(start, int(walked[0]) - 1, 1.0)
	var last := height(target, int(walked[-1]) - 1, 1.0)
	_is_above(first)
	_is_above(last)
	return (first >= 0.0) == (sides[0] > 0.0) and (last >= 0.0) == (sides[-1] > 0.0)


static func is_hit(of: Way) -> bool:
	return of.found == Found.HIT


static func _rank(of: Way) -> int:
	return 100 if is_hit(of) else of.found


func _image(point: Point, wall: int, side: float, ball_radius: float, loss: float) -> Point:
	var above := height(point, wall, side) - ball_radius
	return point.plus(_normal(wall, side), -(above + above / loss))


func _followed(walked: String, sides: PackedFloat64Array) -> Way:
	var images: Array[Point] = [target]
	for place in range(count - 1, -1, -1):
		images.push_front(
			_image(images[0], int(walked[place]) - 1, sides[place], radius, bounciness)
		)
	var found := Way.new()
	found.images = images
	found.sides = sides
	found.order = walked
	found.distance = start.to(images[0]).length()
	found.found = _follow(found, images, sides, walked)
	return found


func _follow(noted: Way, images: Array[Point], sides: PackedFloat64Array, walked: String) -> Found:
	var from := start
	for place in count:
		var wall := int(walked[place]) - 1
		noted.at = wall
		var before := height(from, wall, sides[place]) - radius
		var behind := height(images[place], wall, sides[place]) - radius
		if not _is_above(before):
			return Found.BEHIND
		if not _is_above(-behind):
			return Found.NOT_REACHED
		var to := from.plus(from.to(images[place]), before / (before - behind))
		noted.bounces = place + 1
		var end := _point(walls[wall], 0)
		var along := end.to(_point(walls[wall], 2))
		var share := end.to(to).dot(along) / along.length()
		if not (_is_above(share) and _is_above(along.length() - share)):
			return Found.BESIDE
		if _is_blocked(from, to, int(walked[place - 1]) - 1 if place else -1, wall):
			return Found.BLOCKED
		from = to
	return Found.BLOCKED if _is_blocked(from, target, noted.at as int, -1) else Found.HIT


func _is_blocked(from: Point, to: Point, last: int, next: int) -> bool:
	for wall in walls.size():
		if wall != last and wall != next:
			var gap := _gap(from, to, _point(walls[wall], 0), _point(walls[wall], 2))
			if not _is_above(gap - radius):
				return true
	return false


func _gap(a: Point, b: Point, c: Point, d: Point) -> float:
	if _are_apart(a, b, c, d) and _are_apart(c, d, a, b):
		return 0.0
	return minf(minf(_off(a, c, d), _off(b, c, d)), minf(_off(c, a, b), _off(d, a, b)))


static func _are_apart(a: Point, b: Point, c: Point, d: Point) -> bool:
	var along := a.to(b)
	var one := along.x * (c.y - a.y) - along.y * (c.x - a.x)
	var two := along.x * (d.y - a.y) - along.y * (d.x - a.x)
	return (one < 0.0) != (two < 0.0)


static func _off(point: Point, from: Point, to: Point) -> float:
	var along := from.to(to)
	var square := along.dot(along)
	var share := clampf(from.to(point).dot(along) / square, 0.0, 1.0) if square > 0.0 else 0.0
	return from.plus(along, share).to(point).length()


func is_overlapped() -> bool:
	for wall in walls:
		for point: Point in [start, target]:
			if not _is_above(_off(point, _point(wall, 0), _point(wall, 2)) - radius):
				return true
	return false


func images_of_way() -> Array[Point]:
	return way.images


func wrong_direction() -> Point:
	var walked := way.order
	var sides := way.sides
	if mistake == _MIDPOINT:
		var wall := int(walked[0]) - 1
		var middle := start.plus(start.to(images_of_way()[1]), 0.5)
		var above := height(middle, wall, sides[0]) - radius
		return unit(start.to(middle.plus(_normal(wall, sides[0]), -above)))
	var image := target
	for number in count:
		var place := number if mistake == _WRONG_ORDER else count - 1 - number
		image = _image(
			image,
			int(walked[place]) - 1,
			sides[place],
			0.0 if mistake == _RADIUS_FORGOTTEN else radius,
			1.0 if mistake == _PLAIN_MIRROR else bounciness
		)
	return unit(start.to(image))


static func unit(vector: Point) -> Point:
	return Point.new(0, 0).plus(vector, 1.0 / maxf(vector.length(), 1e-300))


# The smallest distance of a shot from the target; NAN where it bounces often, or nearly touches.
func flown_miss(direction: Point) -> float:
	var from := start
	var velocity := direction
	var distance: float = way.distance
	var left := _TIMES_FOLLOWED * distance
	var least := INF
	for bounce in _MOST_BOUNCES + 1:
		var touch := _next_touch(from, velocity)
		if is_close:
			return NAN
		var at_touch: float = touch[0]
		var time := minf(at_touch, left)
		var to := from.plus(velocity, time)
		least = minf(least, _off(target, from, to))
		left -= time
		if left <= 0.0:
			return least
		var normal: Point = touch[1]
		velocity = velocity.plus(normal, -(1.0 + bounciness) * velocity.dot(normal))
		from = to
	return NAN


# When the ball touches something next while it approaches, and the normal there.
func _next_touch(from: Point, velocity: Point) -> Array:
	var first := INF
	var first_normal: Point = null
	for wall in walls.size():
		for side: float in [1.0, -1.0]:
			var normal := _normal(wall, side)
			var speed := -velocity.dot(normal)
			var time := (height(from, wall, side) - radius) / speed if speed > 0.0 else -1.0
			var end := _point(walls[wall], 0)
			var along := end.to(_point(walls[wall], 2))
			var share := end.to(from.plus(velocity, time)).dot(along) / along.dot(along)
			var is_on := share > 0.0 and share < 1.0
			if is_on and time > -1e-9 * size and time < first:
				first = maxf(time, 0.0)
				first_normal = normal
		for at: int in [0, 2]:
			var to_end := from.to(_point(walls[wall], at))
			var ahead := to_end.dot(velocity) / velocity.dot(velocity)
			var beside := from.plus(velocity, ahead).to(_point(walls[wall], at)).length()
			if ahead > 0.0 and _is_above(radius - beside):
				var back := sqrt(radius ** 2 - beside ** 2) / velocity.length()
				var time := ahead - back
				if time > -1e-9 * size and time < first:
					var centre := from.plus(velocity, time)
					first = maxf(time, 0.0)
					first_normal = unit(_point(walls[wall], at).to(centre))
	return [first, first_normal]
