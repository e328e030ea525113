class_name FastPathKind
extends FuzzKind
## One world flown in several ways that must not matter: with its events kept or not, with the grid
## or without, in one long step or many short ones, with its lines in another order. All are equal
## to the last bit.

const _STEPS := 64


func _init() -> void:
	name = "fast_paths"


func world_of(number: int) -> FuzzWorld:
	var rng := random(number)
	var made := FuzzWorld.new()
	made.bounciness = [1.0, 0.5, 0.9, 0.0, rng.randf()][rng.randi() % 5]
	if rng.randf() < 0.2:
		made.gravity = Vec2.new(0.0, 300.0)
	# A whole number of steps of a power of two adds up exactly.
	made.seconds = 2.0 ** rng.randi_range(0, 2)
	var is_small := rng.randf() < 0.5
	if rng.randf() < 0.75:
		made.walls = [Vec2.zero(), Vec2.new(200.0, 100.0) if is_small else Vec2.new(600.0, 400.0)]
	for place: int in [0, 0, 1, 3, 6][rng.randi() % 5]:
		var start := Vec2.new(rng.randf_range(0.0, 600.0), rng.randf_range(0.0, 400.0))
		var along := Vec2.random_unit(rng).scaled(rng.randf_range(5.0, 200.0))
		made.lines.append(LineSegment.new(start, start.plus(along)))
	for index: int in rng.randi_range(1, 5):
		made.balls.append(_ball(made, rng))
	rub(made, rng)
	return made


func problem_of(world: FuzzWorld) -> String:
	var plain := world.event_world()
	if starts_inside(world, plain):
		return ""
	var found := _fly(plain, world.seconds)
	if found:
		return found
	if plain.impacts > MOST_IMPACTS:
		return ""
	var kept := world.event_world()
	kept.keeps_events = true
	var without_grid := world.event_world(false)
	var turned := world.copy()
	turned.lines.reverse()
	var other_order := turned.event_world()
	for other: WatchedWorld in [kept, without_grid, other_order]:
		found = found if found else _fly(other, world.seconds)
	var stepped := world.event_world()
	for step: int in _STEPS:
		found = found if found else stepped.advance(world.seconds / _STEPS)
	found = found if found else _difference(plain, kept, "with its events kept")
	found = found if found else _difference(plain, without_grid, "without a grid")
	found = found if found else _difference(plain, stepped, "in short steps")
	return found if found else _difference(plain, other_order, "with its lines in another order")


# Some balls touch the one before, or a wall.
func _ball(made: FuzzWorld, rng: RandomNumberGenerator) -> Ball:
	var radius := rng.randf_range(3.0, 15.0)
	var at := Vec2.new(rng.randf_range(20.0, 180.0), rng.randf_range(20.0, 80.0))
	var ball := Ball.new(at, radius, Vec2.random_unit(rng).scaled(rng.randf_range(0.0, 500.0)))
	ball.mass = [1.0, 100.0, 10.0 ** rng.randf_range(-3.0, 3.0)][rng.randi() % 3]
	if rng.randf() < 0.3 and made.balls:
		var last := made.balls[-1]
		var way := Vec2.new(1.0, 0.0) if rng.randf() < 0.5 else Vec2.random_unit(rng)
		ball.position = last.position.plus(way.scaled(last.radius + radius))
	elif rng.randf() < 0.2:
		ball.position = Vec2.new(at.x, radius)
	if rng.randf() < 0.3:
		ball.velocity = Vec2.new(roundf(ball.velocity.x), 0.0)
	return ball


func _fly(flight: WatchedWorld, seconds: float) -> String:
	var refusal := flight.advance(seconds)
	return refusal if not flight.stands_still else "Time stands still."


func _difference(one: WatchedWorld, other: WatchedWorld, how: String) -> String:
	if one.impacts != other.impacts:
		return "There are %d impacts, but %d %s." % [one.impacts, other.impacts, how]
	var numbers := EventWorlds.numbers(one)
	var others := EventWorlds.numbers(other)
	for at: int in numbers.size():
		if not LabTest.same_bits(numbers[at], others[at]):
			var digits := [DecimalText.of(numbers[at]), DecimalText.of(others[at]), how]
			return "A place or velocity is %s, but %s %s." % digits
	return ""
