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
## The best way for each order: found, at, distance, images, sides, order, bounces.
var ways: Dictionary[String, Dictionary] = {}
var way: Dictionary


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
	start = _point(state["start"] as PackedFloat64Array, 0)
	target = _point(state["target"] as PackedFloat64Array, 0)
	radius = state["radius"]
	bounciness = state["bounciness"]
	count = state["bounces"]
	order = state["order"]
	mistake = state["mistake"]
	walls.assign(state["walls"] as Array)
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
	for order in _orders(count):
		var best := {found = Found.NONE, at = int(order[0]) - 1, distance = INF}
		for number in 1 << count:
			var sides: PackedFloat64Array = []
			for place in count:
				sides.append(1.0 if number & (1 << place) else -1.0)
			if _fit(order, sides):
				var way := _followed(order, sides)
				if _rank(way) > _rank(best):
					best = way
		ways[order] = best
	way = ways.values()[0]
	for order in ways:
		var is_better := _rank(ways[order]) > _rank(way)
		var is_shorter := ways[order]["distance"] < way["distance"]
		if (
			order == self.order
			or not self.order and (is_better or is_hit(ways[order]) and is_shorter)
		):
			way = ways[order]
	if self.order:
		way = ways[self.order]


func _orders(length: int) -> PackedStringArray:
	if length == 0:
		return [""]
	var found: PackedStringArray = []
	for order in _orders(length - 1):
		for wall in walls.size():
			if not order.ends_with(str(wall + 1)):
				found.append(order + str(wall + 1))
	return found


# The first wall is met on the side of the start, the last one on that of the target.
func _fit(order: String, sides: PackedFloat64Array) -> bool:
	var first := height(start, int(order[0]) - 1, 1.0)
	var last := height(target, int(order[-1]) - 1, 1.0)
	_is_above(first)
	_is_above(last)
	return (first >= 0.0) == (sides[0] > 0.0) and (last >= 0.0) == (sides[-1] > 0.0)


static func is_hit(way: Dictionary) -> bool:
	return way["found"] == Found.HIT


static func _rank(way: Dictionary) -> int:
	return 100 if is_hit(way) else way["found"]


func _image(point: Point, wall: int, side: float, radius: float, loss: float) -> Point:
	var height := height(point, wall, side) - radius
	return point.plus(_normal(wall, side), -(height + height / loss))


func _followed(order: String, sides: PackedFloat64Array) -> Dictionary:
	var images: Array[Point] = [target]
	for place in range(count - 1, -1, -1):
		images.push_front(
			_image(images[0], int(order[place]) - 1, sides[place], radius, bounciness)
		)
	var way := {images = images, sides = sides, order = order, at = -1, bounces = 0}
	way["distance"] = start.to(images[0]).length()
	way["found"] = _follow(way, images, sides, order)
	return way


func _follow(
	way: Dictionary, images: Array[Point], sides: PackedFloat64Array, order: String
) -> Found:
	var from := start
	for place in count:
		var wall := int(order[place]) - 1
		way["at"] = wall
		var before := height(from, wall, sides[place]) - radius
		var behind := height(images[place], wall, sides[place]) - radius
		if not _is_above(before):
			return Found.BEHIND
		if not _is_above(-behind):
			return Found.NOT_REACHED
		var to := from.plus(from.to(images[place]), before / (before - behind))
		way["bounces"] = place + 1
		var ends := [_point(walls[wall], 0), _point(walls[wall], 2)]
		var along: Point = ends[0].to(ends[1])
		var share: float = ends[0].to(to).dot(along) / along.length()
		if not (_is_above(share) and _is_above(along.length() - share)):
			return Found.BESIDE
		if _is_blocked(from, to, int(order[place - 1]) - 1 if place else -1, wall):
			return Found.BLOCKED
		from = to
	return Found.BLOCKED if _is_blocked(from, target, way["at"] as int, -1) else Found.HIT


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


func images() -> Array[Point]:
	return way["images"]


func wrong_direction() -> Point:
	var order: String = way["order"]
	var sides: PackedFloat64Array = way["sides"]
	if mistake == _MIDPOINT:
		var wall := int(order[0]) - 1
		var middle := start.plus(start.to(images()[1]), 0.5)
		var height := height(middle, wall, sides[0]) - radius
		return unit(start.to(middle.plus(_normal(wall, sides[0]), -height)))
	var image := target
	for number in count:
		var place := number if mistake == _WRONG_ORDER else count - 1 - number
		image = _image(
			image,
			int(order[place]) - 1,
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
	var distance: float = way["distance"]
	var left := _TIMES_FOLLOWED * distance
	var least := INF
	for bounce in _MOST_BOUNCES + 1:
		var touch := _next_touch(from, velocity)
		if is_close:
			return NAN
		var time: float = minf(touch[0] as float, left)
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
	var found: Array = [INF, null]
	for wall in walls.size():
		for side: float in [1.0, -1.0]:
			var normal := _normal(wall, side)
			var speed := -velocity.dot(normal)
			var time := (height(from, wall, side) - radius) / speed if speed > 0.0 else -1.0
			var start := _point(walls[wall], 0)
			var along := start.to(_point(walls[wall], 2))
			var share := start.to(from.plus(velocity, time)).dot(along) / along.dot(along)
			var is_on := share > 0.0 and share < 1.0
			if is_on and time > -1e-9 * size and time < (found[0] as float):
				found = [maxf(time, 0.0), normal]
		for at: int in [0, 2]:
			var to_end := from.to(_point(walls[wall], at))
			var ahead := to_end.dot(velocity) / velocity.dot(velocity)
			var beside := from.plus(velocity, ahead).to(_point(walls[wall], at)).length()
			if ahead > 0.0 and _is_above(radius - beside):
				var back := sqrt(radius ** 2 - beside ** 2) / velocity.length()
				var time := ahead - back
				if time > -1e-9 * size and time < (found[0] as float):
					var centre := from.plus(velocity, time)
					found = [maxf(time, 0.0), unit(_point(walls[wall], at).to(centre))]
	return found
