class_name FrictionKind
extends FuzzKind
## Balls that spin among lines that rub, in a box or in the open: time goes on, no ball is inside
## anything, and the energy never grows. What pushes a ball pushes it where both touch, no harder
## along the surface than friction can: so the angular momentum about that point is kept. One long
## step gives the same bits as many short ones. Balls in the open do the same in a frame that moves.

## How many steps are the short ones.
const STEPS := 64
## In another frame the places are the same up to this, in pixels.
const FRAME_ERROR := 1e-9
## So many impacts in the open are compared: after each one the error of a place grows.
const MOST_IN_THE_OPEN := 2

# What rounding adds to a speed, in px/s: as a share of those before and after, and of those of a
# faster flight before.
const _ROUNDING := 1e-12
const _FASTEST := 1000.0


func _init() -> void:
	name = "friction"


func world_of(number: int) -> FuzzWorld:
	var rng := random(number)
	var made := FuzzWorld.new()
	made.bounciness = [1.0, 0.5, 0.0, 0.9, rng.randf()][rng.randi() % 5]
	made.friction = [0.0, 0.1, 0.5, 1.0, 2.0, rng.randf_range(0.0, 2.0)][rng.randi() % 6]
	made.seconds = 2.0 ** rng.randi_range(0, 1)
	if rng.randf() < 0.8:
		made.gravity = Vec2.new(0.0, 300.0 if rng.randf() < 0.5 else 600.0)
	var is_open := rng.randf() < 0.2
	if not is_open and rng.randf() < 0.7:
		made.walls = [Vec2.zero(), Vec2.new(300.0, 200.0)]
	for place: int in 0 if is_open else rng.randi_range(0, 5):
		made.lines.append(_line(made, rng))
	for index: int in rng.randi_range(1, 5):
		made.balls.append(_ball(made, rng))
	return made


func problem_of(world: FuzzWorld) -> String:
	var flight := world.event_world()
	if _problem_now(flight):
		return ""
	flight.keeps_events = true
	var energy := EnergyCheck.new()
	energy.allowed = EnergyCheck.of_hops(world.balls, world.gravity)
	for step: int in STEPS:
		var found := energy.problem(balls_of(flight), world.gravity)
		found = found if found else flight.fly_to(world.seconds * (step + 1) / STEPS)
		found = found if found else _problem_now(flight)
		for event: WorldEvent in flight.events:
			found = found if found else _problem_of_push(flight, event)
		flight.events.clear()
		if found:
			return found
		if flight.impacts > MOST_IMPACTS:
			return ""
	return _problem_of_other_ways(world, flight)


func _line(made: FuzzWorld, rng: RandomNumberGenerator) -> LineSegment:
	if made.lines and rng.randf() < 0.5:
		# A chain goes on.
		var from := made.lines[-1].end
		var turn := rng.randf_range(-0.5, 0.5)
		return LineSegment.new(from, from.plus(Vec2.unit_radians(turn).scaled(60.0)))
	var start := Vec2.new(rng.randf_range(0.0, 250.0), rng.randf_range(50.0, 200.0))
	var along := Vec2.unit_radians(rng.randf_range(-0.8, 0.8))
	return LineSegment.new(start, start.plus(along.scaled(rng.randf_range(20.0, 200.0))))


# Some lie on a line, some roll there, some touch the ball before.
func _ball(made: FuzzWorld, rng: RandomNumberGenerator) -> Ball:
	var radius := rng.randf_range(3.0, 15.0)
	var at := Vec2.new(rng.randf_range(20.0, 280.0), rng.randf_range(20.0, 180.0))
	var velocity := Vec2.random_unit(rng).scaled(rng.randf_range(0.0, 300.0))
	var mass: float = [1.0, 10.0 ** rng.randf_range(-2.0, 2.0)][rng.randi() % 2]
	var spin: float = [0.0, rng.randf_range(-60.0, 60.0)][rng.randi() % 2]
	var chance := rng.randf()
	if chance < 0.4 and made.lines:
		var line := made.lines[rng.randi() % made.lines.size()]
		at = line.start.lerped(line.end, rng.randf()).minus(line.normal().scaled(radius))
		velocity = line.along().normalized().scaled(rng.randf_range(-300.0, 300.0))
		if chance < 0.2:
			# Above a line from left to right.
			spin = velocity.dot(line.along().normalized()) / radius
	elif chance < 0.6 and made.balls:
		var last := made.balls[-1]
		at = last.position.plus(Vec2.random_unit(rng).scaled(last.radius + radius))
	return Ball.new(at, radius, velocity, mass, spin)


func _problem_now(flight: WatchedWorld) -> String:
	var balls := balls_of(flight)
	for one: int in balls.size():
		var found := InsideCheck.problem(
			balls[one], flight.nearest_points(balls[one]), PileKind.DEEPEST
		)
		if found:
			return found
		for other: int in one:
			var gap := balls[one].position.distance_to(balls[other].position)
			var inside := balls[one].radius + balls[other].radius - gap
			if inside > PileKind.DEEPEST:
				return "Two balls are inside each other by %s px." % inside
	return ""


# What one impact did to a ball: about the point of contact nothing turns it.
func _problem_of_push(flight: WatchedWorld, event: WorldEvent) -> String:
	if event.kind > WorldEvent.Kind.BALL:
		return ""
	var radius := flight.ball(event.ball).radius
	var change := event.velocity_after.minus(event.velocity_before)
	var size := _FASTEST + event.velocity_after.length() + event.velocity_before.length()
	size += radius * (absf(event.spin_before) + absf(event.spin_after))
	var turned := event.normal.cross(change)
	turned += Disc.INERTIA * radius * (event.spin_after - event.spin_before)
	if not absf(turned) <= _ROUNDING * size:
		return "The angular momentum about a contact changes by %s." % turned
	var push := event.normal.dot(change)
	var along := absf(event.normal.cross(change))
	if not along <= flight.friction() * push + _ROUNDING * size:
		return "Friction of %s px/s is more than %s px/s allow." % [along, push]
	return ""


func _problem_of_other_ways(world: FuzzWorld, flight: WatchedWorld) -> String:
	var long := world.event_world()
	long.keeps_events = true
	var found := long.advance(world.seconds)
	if found:
		return "In one step: " + found
	if EventWorlds.numbers(long) != EventWorlds.numbers(flight):
		return "One long step and many short ones differ."
	if world.lines or world.walls or flight.impacts > MOST_IN_THE_OPEN:
		return ""
	# Of balls that touch at the start, rounding decides which one is pushed first.
	if EventWorlds.deepest_overlap(world.event_world()) > -PileKind.DEEPEST:
		return ""
	return _problem_in_frame(world, flight, Vec2.new(70.0, -40.0))


func _problem_in_frame(world: FuzzWorld, flight: WatchedWorld, wind: Vec2) -> String:
	var moved := world.copy()
	for ball: Ball in moved.balls:
		ball.velocity.add(wind)
	var other := moved.event_world()
	var found := other.advance(world.seconds)
	if found:
		return "In a frame that moves: " + found
	for index: int in flight.ball_count():
		var there := other.position(index).minus(wind.scaled(world.seconds))
		var error := there.distance_to(flight.position(index))
		if not error <= FRAME_ERROR:
			return "In a frame that moves a ball is off by %s px." % error
	return ""
