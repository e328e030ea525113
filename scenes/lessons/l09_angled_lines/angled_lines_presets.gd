class_name AngledLinesPresets
extends RefCounted
## The presets of the lesson on angled lines: the course's scenes of week 3, on the keys 0 to 9, and
## week 4 with its endless lines. In the lesson, preset 0 is what its scene has at the start.

## The title of each preset, by its key: source text.
const TITLES: PackedStringArray = [
	"Assignment",
	"Corner, slow",
	"Corner, fast",
	"Ramps",
	"Five cells",
	"Tunnelling",
	"Diagonal",
	"Ten balls",
	"Fifty balls",
	"Energy",
	"Week 4: endless lines",
]
## The preset whose lines are endless. It has no key.
const WEEK_4 := 10

# Lines as x and y of both ends, in pixels.
const _BOX: Array[Vector4i] = [
	Vector4i(-270, -178, 280, -160),
	Vector4i(280, -160, 260, 180),
	Vector4i(260, 180, -262, 160),
	Vector4i(-262, 160, -270, -178),
]
const _ASSIGNMENT: Array[Vector4i] = [
	Vector4i(-210, -60, -90, 10),
	Vector4i(60, 50, 180, -10),
	Vector4i(-60, -100, 40, -80),
	Vector4i(-170, 80, -60, 100),
	Vector4i(120, -120, 200, -60),
	Vector4i(20, 120, 110, 90),
]
const _MANY: Array[Vector4i] = [
	Vector4i(-230, -80, -180, -50),
	Vector4i(-140, -120, -100, -90),
	Vector4i(-60, -80, -10, -100),
	Vector4i(40, -110, 90, -80),
	Vector4i(130, -70, 180, -100),
	Vector4i(210, -30, 240, -70),
	Vector4i(-190, 10, -140, -20),
	Vector4i(-100, -10, -50, 20),
	Vector4i(10, -10, 60, -30),
	Vector4i(110, 10, 160, 40),
	Vector4i(-240, 70, -190, 100),
	Vector4i(-140, 80, -90, 60),
	Vector4i(-50, 90, 0, 120),
	Vector4i(50, 90, 100, 70),
	Vector4i(140, 90, 190, 120),
	Vector4i(200, 50, 240, 20),
]
const _CORNER: Array[Vector4i] = [Vector4i(90, -140, 225, 40), Vector4i(225, 40, 105, 130)]
const _STACK: Array[Vector4i] = [
	Vector4i(-220, -110, 120, -70),
	Vector4i(220, -50, -120, -10),
	Vector4i(-220, 10, 120, 50),
	Vector4i(220, 70, -120, 110),
]
const _WALLS: Array[Vector4i] = [
	Vector4i(-20, -120, 20, 120), Vector4i(50, -120, 90, 120), Vector4i(160, -120, 160, 120)
]
# From the right to the left, so that the normal points up.
const _RAMP: Array[Vector4i] = [Vector4i(90, 0, -60, 40)]
const _DIAGONAL: Array[Vector4i] = [Vector4i(-20, 110, 160, -70)]

const _DOWN := Vector2i(0, 300)
const _NONE := Vector2i(0, 0)


## The world of the preset [param number], 0 to 10, at its start.
static func world_of(number: int) -> SteppedWorld:
	match number:
		1:
			return _world(_BOX + _CORNER, _NONE, 1.0, [_ball(-240, 0, 240, 30, 12)])
		2:
			return _world(_BOX + _CORNER, _NONE, 1.0, [_ball(-240, 0, 7200, 900, 12)])
		3:
			return _world(_BOX + _STACK, _DOWN, 0.5, _row_of_balls())
		4:
			return _cradle()
		5:
			return _world(_WALLS + _BOX, _NONE, 1.0, [_ball(-150, -5, 6600, 600, 12)])
		6:
			return _world(_BOX + _DIAGONAL, _NONE, 1.0, [_ball(-220, 20, 240, 0, 16)])
		7:
			return _world(_BOX + _ASSIGNMENT, _DOWN, 1.0, _swarm(10, 9, _BOX + _ASSIGNMENT))
		8:
			return _world(_BOX + _MANY, _DOWN, 1.0, _swarm(50, 6, _BOX + _MANY))
		9:
			return _world(_BOX, _DOWN, 1.0, [_ball(-150, -110, 60, 0, 14)])
		WEEK_4:
			return _world(
				_BOX + _RAMP, _DOWN, 0.8, [_ball(40, -110, -60, 0, 14), _ball(120, 110, 0, 0, 14)]
			)
	return _world(_BOX + _ASSIGNMENT, _DOWN, 1.0, [_ball(-200, -120, 160, 0, 12)])


static func _world(
	lines: Array[Vector4i], gravity: Vector2i, bounciness: float, balls: Array[Ball]
) -> SteppedWorld:
	var world := SteppedWorld.new(WholeFrameMover.new())
	Refusal.push(world.surroundings.set_segments(_segments(lines)))
	Refusal.push(world.surroundings.set_gravity(Vec2.new(gravity.x, gravity.y)))
	Refusal.push(world.surroundings.set_bounciness(bounciness))
	Refusal.push(world.set_balls(balls))
	return world


static func _segments(lines: Array[Vector4i]) -> Array[LineSegment]:
	var segments: Array[LineSegment] = []
	for line in lines:
		segments.append(LineSegment.new(Vec2.new(line.x, line.y), Vec2.new(line.z, line.w)))
	return segments


static func _ball(x: int, y: int, velocity_x: int, velocity_y: int, radius: int) -> Ball:
	return Ball.new(Vec2.new(x, y), radius, Vec2.new(velocity_x, velocity_y))


static func _row_of_balls() -> Array[Ball]:
	return [_ball(-190, -130, 0, 0, 12), _ball(-150, -130, 0, 0, 12), _ball(-110, -130, 0, 0, 12)]


# Balls in the order of a sunflower's seeds, so that they do not overlap, each in a direction of its
# own. Places where a ball would overlap a line stay empty.
static func _swarm(count: int, radius: int, lines: Array[Vector4i]) -> Array[Ball]:
	var segments := _segments(lines)
	var balls: Array[Ball] = []
	var i := 0
	while balls.size() < count:
		var place := Vec2.unit_degrees(137.5 * i).scaled(18.0 * sqrt(i + 0.5))
		place.x *= 1.4
		if _is_clear(place, radius, segments):
			balls.append(Ball.new(place, radius, Vec2.unit_degrees(222.5 * i).scaled(150.0)))
		i += 1
	return balls


static func _is_clear(place: Vec2, radius: float, segments: Array[LineSegment]) -> bool:
	for segment in segments:
		if segment.closest_point(place).distance_to(place) <= radius:
			return false
	return true


# Five cells in a row, tilted by the triangle 7, 24, 25, so that all numbers are short. The ball in
# cell k goes to and fro k times a second: once a second all balls are back on the same side.
static func _cradle() -> SteppedWorld:
	var along := Vec2.new(0.96, 0.28)
	var lines: Array[LineSegment] = []
	var balls: Array[Ball] = []
	for wall in 6:
		var foot := along.scaled(-275.0 + 110.0 * wall)
		var half := along.normal().scaled(90.0)
		lines.append(LineSegment.new(foot.minus(half), foot.plus(half)))
		if wall > 0:
			var start := foot.minus(along.scaled(98.0))
			balls.append(Ball.new(start, 12.0, along.scaled(172.0 * wall)))
	var world := _world([], _NONE, 1.0, balls)
	Refusal.push(world.surroundings.set_segments(lines))
	return world
