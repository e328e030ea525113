class_name WorkshopReferenceAim
extends RefCounted
## Right answers to the exercises about aiming, by the lab's own code.


## See exercise 13.
static func lead_time(place: Vec2, velocity: Vec2, speed: float) -> float:
	var aim := LeadAim.first(Vec2.zero(), AimTarget.new(place, velocity), speed)
	return aim.time if aim.hit else INF


## See exercise 13.
static func lead(place: Vec2, velocity: Vec2, speed: float) -> Vec2:
	var aim := LeadAim.first(Vec2.zero(), AimTarget.new(place, velocity), speed)
	return aim.direction if aim.hit else Vec2.zero()


## See exercise 14.
static func flat_arc(place: Vec2, gravity: float, speed: float) -> Vec2:
	var shots := BallisticAim.at_fixed(Vec2.zero(), place, Vec2.new(0.0, gravity), speed)
	return shots[0].direction if shots else Vec2.zero()


## See exercise 14.
static func high_arc(place: Vec2, gravity: float, speed: float) -> Vec2:
	var shots := BallisticAim.at_fixed(Vec2.zero(), place, Vec2.new(0.0, gravity), speed)
	return shots[-1].direction if shots else Vec2.zero()


## See exercise 15.
static func bank(
	start: Vec2, target: Vec2, radius: float, bounciness: float, line_start: Vec2, line_end: Vec2
) -> Vec2:
	var wall := LineSegment.new(line_start, line_end)
	var image := BankAim.image_by_the_slide(start, target, radius, bounciness, wall)
	return image.minus(start).normalized()


## See exercise 15.
static func bank_twice(
	start: Vec2,
	target: Vec2,
	radius: float,
	first_start: Vec2,
	first_end: Vec2,
	second_start: Vec2,
	second_end: Vec2
) -> Vec2:
	var first := LineSegment.new(first_start, first_end)
	var second := LineSegment.new(second_start, second_end)
	var image := BankAim.image_by_the_slide(start, target, radius, 1.0, second)
	return BankAim.image_by_the_slide(start, image, radius, 1.0, first).minus(start).normalized()
