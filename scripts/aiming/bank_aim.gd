class_name BankAim
extends RefCounted
## Aims over walls: a ball that bounces flies straight at the mirror image of its target.
##
## Each wall is moved by the ball's radius to the ball's side, and the target is mirrored in the
## last wall first, then backwards. Where a bounce keeps only C of the speed along the normal, the
## image lies 1/C times as far behind the wall: then the speed in the unfolded picture is constant,
## too.


## The way from [param start] to [param target], both places of the ball's centre, with exactly
## [param bounces] bounces that arrives first. Each bounce is on the line part of a wall, on either
## side, and the ball touches nothing else. [param bounciness] is C, above 0 and at most 1.
static func first(
	start: Vec2,
	target: Vec2,
	radius: float,
	bounciness: float,
	walls: Array[LineSegment],
	bounces: int
) -> BankWay:
	if not can_bounce(bounciness, bounces):
		return BankWay.new()
	return BankSearch.new(start, target, radius, bounciness, walls).first(bounces)


## All orders of walls with that many bounces, each with what becomes of it.
static func ways(
	start: Vec2,
	target: Vec2,
	radius: float,
	bounciness: float,
	walls: Array[LineSegment],
	bounces: int
) -> Array[BankWay]:
	if not can_bounce(bounciness, bounces):
		return []
	return BankSearch.new(start, target, radius, bounciness, walls).ways(bounces)


## The image of a target as a slide writes it: T' = T - (1 + 1/C) ((T - o)·n - r) n, with a point o
## of the wall and its normal n on the side of [param start].
static func image_by_the_slide(
	start: Vec2, target: Vec2, radius: float, bounciness: float, wall: LineSegment
) -> Vec2:
	var normal := wall.normal()
	if normal.dot(start.minus(wall.start)) < 0.0:
		normal = normal.negated()
	var height := normal.dot(target.minus(wall.start)) - radius
	return target.minus(normal.scaled((1.0 + 1.0 / bounciness) * height))


## The same as [method first] by the formula of the slide alone: the way to the nearest image. It
## does not look whether the ball meets the walls between their ends, in this order, and nothing
## before: with one wall that is long enough it is right.
static func first_by_the_slide(
	start: Vec2,
	target: Vec2,
	radius: float,
	bounciness: float,
	walls: Array[LineSegment],
	bounces: int
) -> BankWay:
	if not can_bounce(bounciness, bounces):
		return BankWay.new()
	var way := BankWay.new()
	way.images = [target.copy()]
	return _nearest_image(start, way, radius, bounciness, walls, bounces)


## Whether a ball can be aimed over walls with this C, above 0 and at most 1, and so many bounces,
## 0 or more. Else it is an error.
static func can_bounce(bounciness: float, bounces: int) -> bool:
	if not (bounciness > 0.0 and bounciness <= 1.0):
		push_error("To aim over walls, C must be above 0 and at most 1, but is %s." % bounciness)
	elif bounces < 0:
		push_error("The number of bounces must be 0 or more, but is %d." % bounces)
	else:
		return true
	return false


# Mirrors the first image of [param way] in each wall but the one that it was mirrored in last.
static func _nearest_image(
	start: Vec2,
	way: BankWay,
	radius: float,
	bounciness: float,
	walls: Array[LineSegment],
	bounces: int
) -> BankWay:
	var best := BankWay.new()
	if bounces == 0:
		best.hit = true
		best.outcome = BankWay.Outcome.HIT
		best.direction = way.images[0].minus(start).normalized()
		best.distance = way.images[0].distance_to(start)
		best.images = way.images
		best.walls = way.walls
		return best
	for wall in walls.size():
		if way.walls and way.walls[0] == wall:
			continue
		var longer := BankWay.new()
		var image := image_by_the_slide(start, way.images[0], radius, bounciness, walls[wall])
		longer.images = way.images.duplicate()
		longer.images.push_front(image)
		longer.walls = PackedInt32Array([wall]) + way.walls
		var found := _nearest_image(start, longer, radius, bounciness, walls, bounces - 1)
		if found.distance < best.distance:
			best = found
	return best
