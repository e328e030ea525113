class_name BankShotKind
extends ShotKind
## Shots over walls: ball 0 is the ball, ball 1 is where its centre must come to, and
## [member FuzzWorld.seconds], rounded up, is the number of bounces.

# A search tries so many directions.
const _DIRECTIONS := 90
const _MOST_BOUNCES := 3
# Pixels. The centre is farther than this from touching any wall at both ends.
const _ROOM := 0.01


func _init() -> void:
	name = "shots_bank"


func world_of(number: int) -> FuzzWorld:
	var rng := random(number)
	var made := FuzzWorld.new()
	made.seconds = 1.0 + rng.randi() % 3
	made.bounciness = 1.0 if rng.randf() < 0.5 else rng.randf_range(0.3, 1.0)
	if rng.randf() < 0.7:
		var corners: Array[Vec2] = [
			Vec2.new(-450, -350), Vec2.new(450, -350), Vec2.new(450, 350), Vec2.new(-450, 350)
		]
		for index: int in corners.size():
			made.lines.append(LineSegment.new(corners[index - 1], corners[index]))
	for more: int in rng.randi_range(1, 3):
		var from := place(rng)
		made.lines.append(LineSegment.new(from, from.plus(vector(rng, 50.0, 500.0))))
	var radius := POINT if rng.randf() < 0.2 else rng.randf_range(1.0, 20.0)
	var ball := Ball.new(place(rng), radius, Vec2.new(300.0, 0.0))
	made.balls = [ball, Ball.new(place(rng), POINT)]
	if rng.randf() < 0.1:
		move_far(made, rng)
	return made


func can_be_asked(world: FuzzWorld) -> bool:
	if not super(world) or world.bounciness <= 0.0:
		return false
	for line: LineSegment in world.lines:
		for ball: Ball in [world.balls[0], world.balls[1]]:
			var distance := line.closest_point(ball.position).distance_to(ball.position)
			if distance <= world.balls[0].radius + _ROOM:
				return false
	return true


func problem_of_shots(world: FuzzWorld) -> String:
	var ball := world.balls[0]
	var bounces := mini(ceili(world.seconds), _MOST_BOUNCES)
	var way := BankAim.first(
		ball.position, world.balls[1].position, ball.radius, world.bounciness, world.lines, bounces
	)
	var found := _earlier(world, way, bounces)
	return found if found or not way.hit else _problem_of_way(world, way)


func _problem_of_way(world: FuzzWorld, way: BankWay) -> String:
	var ball := world.balls[0]
	var speed := ball.velocity.length()
	var velocity := way.direction.scaled(speed)
	var shot := FiredShot.new(
		ball.position, velocity, Vec2.zero(), ball.radius, world.lines, world.bounciness
	)
	var target := world.balls[1].position
	var missed := shot.place_after(way.distance / speed).minus(target)
	var numbers: PackedFloat64Array = [
		ball.position.x,
		ball.position.y,
		target.x,
		target.y,
		ball.radius,
		world.bounciness,
		way.direction.x,
		way.direction.y,
		way.distance
	]
	for wall: int in way.walls:
		numbers.append_array(FuzzWorld.numbers_of_line(world.lines[wall]))
	return problem_of_flight(missed, numbers, _miss)


# Between two neighbouring directions that pass the target on different sides, after bounces off the
# same walls, there is one that hits, unless a wall ends between them.
func _earlier(world: FuzzWorld, way: BankWay, bounces: int) -> String:
	var before := PassedTarget.of(world, 0.0, bounces)
	for number: int in range(1, _DIRECTIONS + 1):
		var angle := TAU * number / _DIRECTIONS
		var now := PassedTarget.of(world, angle, bounces)
		if now.passes_otherwise(before):
			var hit := _hit_between(world, before, now, bounces)
			if hit and hit.distance < way.distance * (1.0 - 1e-9) - 1e-6:
				return (
					"A shot with %d bounces hits after %s px already."
					% [bounces, DecimalText.of(hit.distance)]
				)
		before = now
	return ""


# The shot between both; null where a wall ends there.
func _hit_between(
	world: FuzzWorld, low: PassedTarget, high: PassedTarget, bounces: int
) -> PassedTarget:
	for halving: int in 50:
		var middle := PassedTarget.of(world, 0.5 * (low.angle + high.angle), bounces)
		if middle.passes_otherwise(low):
			high = middle
		elif middle.passes_otherwise(high):
			low = middle
		else:
			return null
	return low if absf(low.beside) < 1e-6 else null


# Follows the ball by plain formulas along the walls of the way.
static func _miss(n: PackedFloat64Array) -> Vec2:
	var at := Vec2.new(n[0], n[1])
	var velocity := Vec2.new(n[6], n[7])
	var left := n[8]
	for first: int in range(9, n.size(), 4):
		var wall := FuzzWorld.line_of(n.slice(first, first + 4))
		var normal := wall.normal()
		if normal.dot(velocity) > 0.0:
			normal = normal.negated()
		var height := normal.dot(at.minus(wall.start)) - n[4]
		var time := height / -normal.dot(velocity)
		at.add(velocity.scaled(time))
		velocity.add(normal.scaled(-(1.0 + n[5]) * normal.dot(velocity)))
		left -= time
	return at.plus(velocity.scaled(left)).minus(Vec2.new(n[2], n[3]))
