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
