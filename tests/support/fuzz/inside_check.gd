class_name InsideCheck
extends RefCounted
## Whether a ball is inside a line, and whether it could be anywhere else.

## A ball may be inside a line by this much, in pixels, or by four units in the last place of its
## larger coordinate.
const DEEPEST := 1e-8

const _EPSILON := 1.0 / 2.0 ** 52
const _MOST_PUSHES := 400
# A ball touches what is this near, in pixels.
const _CONTACT := 1e-6


## The nearest point of each of the lines that the ball may touch.
static func points_of(lines: Array[LineSegment], ball: Ball) -> Array[Vec2]:
	var found: Array[Vec2] = []
	var at := ball.position
	# Most lines are far away, and need no nearest point.
	for line: LineSegment in lines:
		var start := line.start
		var end := line.end
		if absf(2.0 * at.x - start.x - end.x) > absf(end.x - start.x) + 3.0 * ball.radius:
			continue
		if absf(2.0 * at.y - start.y - end.y) <= absf(end.y - start.y) + 3.0 * ball.radius:
			found.append(line.closest_point(at))
	return found


## How deep a ball is inside what has these nearest points, in pixels; negative where it is outside.
static func depth(ball: Ball, nearest: Array[Vec2]) -> float:
	var deepest := -INF
	for point: Vec2 in nearest:
		deepest = maxf(deepest, ball.radius - point.distance_to(ball.position))
	return deepest


## "" or by how much the ball is inside, where that is more than [param allowed] pixels.
static func problem(ball: Ball, nearest: Array[Vec2], allowed: float = DEEPEST) -> String:
	var inside := depth(ball, nearest)
	if inside <= maxf(allowed, last_places(ball.position)):
		return ""
	return "The ball at %s is inside a line or wall by %s px." % [ball.position, inside]


## Four units in the last place of the larger coordinate, in pixels.
static func last_places(at: Vec2) -> float:
	return 4.0 * _EPSILON * maxf(absf(at.x), absf(at.y))


## Whether a ball of the world that is inside something can be pushed out: always away from what it
## is deepest in, until it is outside, and without its centre passing a line. Where pushes go to and
## fro for long, as between lines closer than its diameter, it cannot; nor where the next place with
## room is farther away than its diameter.
static func has_room(world: WatchedWorld, index: int) -> bool:
	var ball := world.ball(index)
	var start := ball.position.copy()
	for push: int in _MOST_PUSHES:
		var nearest := world.nearest_points(ball)
		if depth(ball, nearest) <= DEEPEST:
			var is_near := ball.position.distance_to(start) <= 2.0 * ball.radius
			return is_near and not _passes_line(world, start, ball.position)
		var closest := nearest[0]
		for point: Vec2 in nearest:
			if point.distance_to(ball.position) < closest.distance_to(ball.position):
				closest = point
		if closest.distance_to(ball.position) == 0.0:
			return false
		var away := ball.position.minus(closest).normalized()
		ball.position = closest.plus(away.scaled(ball.radius))
	return false


## The balls that lines press into each other: each overlaps another one, and neither of the two can
## move away from the other without moving into what it touches. No bounce lets them out.
static func jammed(world: WatchedWorld) -> PackedInt32Array:
	var found: PackedInt32Array = []
	for one: int in world.ball_places():
		for other: int in world.ball_places():
			var apart := world.position(one).minus(world.position(other))
			var overlap := world.ball(one).radius + world.ball(other).radius - apart.length()
			if other >= one or overlap <= _CONTACT or apart.length() == 0.0:
				continue
			if not (_can_move(world, one, apart) or _can_move(world, other, apart.scaled(-1.0))):
				found.append_array([one, other])
	return found


# Whether a ball has a way, not against this direction, on which it comes nearer to nothing that it
# touches. If there is one, it is this direction or one along something that it touches.
static func _can_move(world: WatchedWorld, index: int, direction: Vec2) -> bool:
	var ball := world.ball(index)
	var ways: Array[Vec2] = [direction.normalized()]
	var normals: Array[Vec2] = []
	for point: Vec2 in world.nearest_points(ball):
		var away := ball.position.minus(point)
		if away.length() <= ball.radius + _CONTACT and away.length() > 0.0:
			normals.append(away.normalized())
			ways.append(normals[-1].normal())
			ways.append(normals[-1].normal().scaled(-1.0))
	return ways.any(
		func(way: Vec2) -> bool:
			var is_free := normals.all(
				func(normal: Vec2) -> bool: return way.dot(normal) > -_CONTACT
			)
			return is_free and way.dot(direction) > 0.0
	)


static func _passes_line(world: WatchedWorld, from: Vec2, to: Vec2) -> bool:
	var way := to.minus(from)
	for line: LineSegment in world.lines():
		var along := line.along()
		var sides := along.cross(from.minus(line.start)) * along.cross(to.minus(line.start))
		var ends := way.cross(line.start.minus(from)) * way.cross(line.end.minus(from))
		if sides <= 0.0 and ends <= 0.0 and way.length() > 0.0:
			return true
	return false
