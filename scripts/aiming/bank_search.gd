class_name BankSearch
extends RefCounted
## The search of [BankAim] through all orders of walls.

var _start: Vec2
# Everything is counted from the start: so no digit is lost far away from the origin.
var _target: Vec2
var _radius: float
# How far behind the wall the image lies, beside how far before it the target is: 1 + 1/C.
var _mirror: float
var _walls: Array[LineSegment] = []
var _normals: Array[Vec2] = []


## See [method BankAim.first].
func _init(
	start: Vec2, target: Vec2, radius: float, bounciness: float, walls: Array[LineSegment]
) -> void:
	_start = start
	_target = target.minus(start)
	_radius = radius
	_mirror = 1.0 + 1.0 / bounciness
	for wall in walls:
		_walls.append(LineSegment.new(wall.start.minus(start), wall.end.minus(start)))
		_normals.append(wall.normal())


## See [method BankAim.first].
func first(bounces: int) -> BankWay:
	var best := BankWay.new()
	for order in _orders(bounces):
		for sides in _sides(order):
			var way := _unfolded(order, sides)
			# Most ways are longer than the best one: they need not be followed.
			if way.distance < best.distance:
				_follow_to_the_end(way, sides)
				if way.hit:
					best = way
	return best


## See [method BankAim.ways].
func ways(bounces: int) -> Array[BankWay]:
	var found: Array[BankWay] = []
	for order in _orders(bounces):
		for sides in _sides(order):
			found.append(_unfolded(order, sides))
			_follow_to_the_end(found[-1], sides)
	return found


# All orders of so many walls; no wall comes twice in a row.
func _orders(count: int) -> Array[PackedInt32Array]:
	if count == 0:
		return [PackedInt32Array()]
	var found: Array[PackedInt32Array] = []
	for order in _orders(count - 1):
		for wall in _walls.size():
			if order.is_empty() or order[-1] != wall:
				found.append(order + PackedInt32Array([wall]))
	return found


# On which side of each wall the ball may bounce, 1 where its normal points, else -1. That of the
# first one follows from the start, that of the last one from the target.
func _sides(order: PackedInt32Array) -> Array[PackedFloat64Array]:
	var found: Array[PackedFloat64Array] = [PackedFloat64Array()]
	for place in order.size():
		var may_be: PackedFloat64Array = [1.0, -1.0]
		if place == 0:
			may_be = [_side_of(order[place], Vec2.zero())]
			if order.size() == 1 and _side_of(order[place], _target) != may_be[0]:
				return []
		elif place == order.size() - 1:
			may_be = [_side_of(order[place], _target)]
		var longer: Array[PackedFloat64Array] = []
		for sides in found:
			for side in may_be:
				longer.append(sides + PackedFloat64Array([side]))
		found = longer
	return found


func _side_of(wall: int, point: Vec2) -> float:
	return 1.0 if _normals[wall].dot(point.minus(_walls[wall].start)) >= 0.0 else -1.0


# The straight way to the image of the target.
func _unfolded(order: PackedInt32Array, sides: PackedFloat64Array) -> BankWay:
	var way := BankWay.new()
	way.walls = order
	way.sides = sides
	way.images = [_target.copy()]
	for place in range(order.size() - 1, -1, -1):
		way.images.push_front(_image(way.images[0], order[place], sides[place]))
	way.direction = way.images[0].normalized()
	way.distance = way.images[0].length()
	return way


func _follow_to_the_end(way: BankWay, sides: PackedFloat64Array) -> void:
	way.outcome = _follow(way, sides)
	way.hit = way.outcome == BankWay.Outcome.HIT
	for point: Vec2 in way.images + way.bounces:
		point.add(_start)


# How far the ball's centre at this point is from where it touches the wall on that side.
func _height(point: Vec2, wall: int, side: float) -> float:
	return side * _normals[wall].dot(point.minus(_walls[wall].start)) - _radius


func _image(point: Vec2, wall: int, side: float) -> Vec2:
	return point.minus(_normals[wall].scaled(side * _mirror * _height(point, wall, side)))


# From bounce to bounce; notes the bounces and says what is wrong.
func _follow(way: BankWay, sides: PackedFloat64Array) -> BankWay.Outcome:
	var from := Vec2.zero()
	var last := -1
	for place in way.walls.size():
		var wall := way.walls[place]
		var before := _height(from, wall, sides[place])
		var behind := _height(way.images[place], wall, sides[place])
		if not before > 0.0:
			return BankWay.Outcome.BEHIND
		if not behind < 0.0:
			return BankWay.Outcome.NOT_REACHED
		var to := from.lerped(way.images[place], before / (before - behind))
		way.bounces.append(to)
		var share := _walls[wall].share_of(to)
		if not (share > 0.0 and share < 1.0):
			return BankWay.Outcome.BESIDE
		if _is_blocked(from, to, last, wall):
			return BankWay.Outcome.BLOCKED
		from = to
		last = wall
	return BankWay.Outcome.BLOCKED if _is_blocked(from, _target, last, -1) else BankWay.Outcome.HIT


# Whether the ball touches a wall on this leg, but for the one that it comes from and the one that
# it goes to.
func _is_blocked(from: Vec2, to: Vec2, last: int, next: int) -> bool:
	var leg := LineSegment.new(from, to)
	for wall in _walls.size():
		if wall != last and wall != next and leg.distance_to(_walls[wall]) <= _radius:
			return true
	return false
