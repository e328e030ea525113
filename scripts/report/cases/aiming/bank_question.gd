class_name BankQuestion
extends RefCounted
## How to come to a place over walls: what is asked, and by how much a shot misses.

## Where the ball's centre starts, in pixels.
var start: Vec2
## Where it must come to, in pixels.
var target: Vec2
## The ball's radius, in pixels.
var radius: float
## C, above 0 and at most 1.
var bounciness: float
## What it may bounce off.
var walls: Array[LineSegment] = []
## How many times it bounces before it is there.
var bounces: int


## By how much a shot in [param direction] misses, in pixels: the ball is followed with 100 bits,
## bounce by bounce, and then until the next wall. What does not bounce as often misses by the least
## distance on its last way.
func miss(direction: Vec2) -> float:
	var place := ExactVector.from_vec2(start)
	var velocity := ExactVector.from_vec2(direction)
	var next := _next_impact(place, velocity)
	for bounce in bounces:
		if not next.hit:
			break
		place = place.plus(velocity.scaled(next.time))
		velocity = _bounced(velocity, next.normal)
		next = _next_impact(place, velocity)
	var way := target.distance_to(place.to_vec2()) / velocity.to_vec2().length()
	var longest := next.time.to_float() if next.hit else 2.0 * way
	var approach := ExactApproach.new(place.minus(ExactVector.from_vec2(target)), velocity)
	return approach.least_distance(longest, way)


## The same for a result of the aiming code; NAN for one without a hit.
func miss_of(way: BankWay) -> float:
	return miss(way.direction) if way.hit else NAN


# In units of time in which the ball flies by its velocity.
func _next_impact(place: ExactVector, velocity: ExactVector) -> ExactImpact:
	var first := ExactImpact.new()
	for wall in walls:
		var impact := ExactImpact.with_segment(place, velocity, radius, wall)
		if impact.hit and (not first.hit or impact.time.is_less_than(first.time)):
			first = impact
	return first


func _bounced(velocity: ExactVector, normal: ExactVector) -> ExactVector:
	var share := velocity.dot(normal).divided(normal.dot(normal))
	return velocity.minus(normal.scaled(share.times(DoubleDouble.sum_of(1.0, bounciness))))
