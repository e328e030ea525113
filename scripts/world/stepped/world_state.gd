class_name WorldState
extends RefCounted
## Turns a stepped world into a dictionary of numbers, for undo and links, and back.


## Everything but the mover: lines, gravity, bounciness, balls, counters.
static func of(world: SteppedWorld) -> Dictionary:
	var ends: PackedFloat64Array = []
	for line in world.surroundings.segments:
		ends.append_array([line.start.x, line.start.y, line.end.x, line.end.y])
	var radii: PackedFloat64Array = []
	for ball in world.balls:
		radii.append(ball.radius)
	var gravity := world.surroundings.gravity
	return {
		"gravity": PackedFloat64Array([gravity.x, gravity.y]),
		"bounciness": world.surroundings.bounciness,
		"lines": ends,
		"radii": radii,
		"moving": world.state(),
	}


## Puts back what [method of] has stored. Returns "", or the first sentence with which the world
## refused a part of it.
static func put(stored: Dictionary, world: SteppedWorld) -> String:
	var gravity: PackedFloat64Array = stored["gravity"]
	var bounciness: float = stored["bounciness"]
	var ends: PackedFloat64Array = stored["lines"]
	var radii: PackedFloat64Array = stored["radii"]
	var moving: PackedFloat64Array = stored["moving"]
	var balls: Array[Ball] = []
	for radius in radii:
		balls.append(Ball.new(Vec2.new(), radius))
	var problems: PackedStringArray = [
		world.surroundings.set_gravity(Vec2.new(gravity[0], gravity[1])),
		world.surroundings.set_bounciness(bounciness),
		world.surroundings.set_segments(_lines(ends)),
		world.set_balls(balls),
		world.put_state(moving),
	]
	for problem in problems:
		if problem:
			return problem
	return ""


static func _lines(ends: PackedFloat64Array) -> Array[LineSegment]:
	var found: Array[LineSegment] = []
	for i in range(0, ends.size(), 4):
		var start := Vec2.new(ends[i], ends[i + 1])
		found.append(LineSegment.new(start, Vec2.new(ends[i + 2], ends[i + 3])))
	return found
