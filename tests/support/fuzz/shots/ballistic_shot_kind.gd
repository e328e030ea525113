class_name BallisticShotKind
extends ShotKind
## Shots under gravity at a point that rests: both arcs, and nothing between or beyond them.


func _init() -> void:
	name = "shots_ballistic"


func world_of(number: int) -> FuzzWorld:
	var rng := random(number)
	var made := FuzzWorld.new()
	made.gravity = vector(rng, 10.0, 800.0)
	var bullet := Ball.new(place(rng), POINT)
	var target := Ball.new(place(rng), POINT)
	if rng.randf() < 0.1:
		# Straight against gravity, or along it.
		var along := made.gravity.normalized().scaled(rng.randf_range(-400.0, 400.0))
		target.position = bullet.position.plus(along)
	var least := BallisticAim.least_speed(bullet.position, target.position, made.gravity)
	var factor := rng.randf_range(0.7, 2.5)
	if rng.randf() < 0.2:
		factor = 1.0 + 10.0 ** rng.randf_range(-15.0, -3.0)
	bullet.velocity = Vec2.new(maxf(factor * least, 1.0), 0.0)
	made.balls = [bullet, target]
	if rng.randf() < 0.1:
		move_far(made, rng)
	return made


func problem_of_shots(world: FuzzWorld) -> String:
	var shooter := world.balls[0].position
	var speed := world.balls[0].velocity.length()
	var target := world.balls[1].position
	if target.distance_to(shooter) == 0.0:
		return ""
	var shots := BallisticAim.at_fixed(shooter, target, world.gravity, speed)
	var found := _other(world, shots)
	for shot: Aim in shots:
		found = found if found else _problem_of_shot(world, shot, speed)
	return found


func _problem_of_shot(world: FuzzWorld, aim: Aim, speed: float) -> String:
	var shooter := world.balls[0].position
	var target := world.balls[1].position
	var shot := FiredShot.new(shooter, aim.direction.scaled(speed), world.gravity)
	var numbers: PackedFloat64Array = [
		shooter.x,
		shooter.y,
		target.x,
		target.y,
		world.gravity.x,
		world.gravity.y,
		speed,
		aim.direction.x,
		aim.direction.y,
		aim.time
	]
	return problem_of_flight(shot.place_after(aim.time).minus(target), numbers, _miss)


# The bullet is too slow before the flat arc and after the high one, and too fast between them.
func _other(world: FuzzWorld, shots: Array[Aim]) -> String:
	var shooter := world.balls[0].position
	var speed := world.balls[0].velocity.length()
	var way := world.balls[1].position.minus(shooter)
	var pull := world.gravity.length()
	var size := shooter.length() + way.length()
	var last := 3.0 * (shots[-1].time if shots else sqrt(2.0 * way.length() / maxf(pull, 1e-9)))
	for time: float in moments(last):
		var is_between := shots.size() > 0 and time > shots[0].time
		is_between = is_between and (shots.size() == 1 or time < shots[1].time)
		var needed := way.minus(world.gravity.scaled(0.5 * time * time)).length()
		var gap := (needed - speed * time) * (-1.0 if is_between else 1.0)
		if gap < -rounding([size, pull * time * time, speed * time]):
			return "There is a shot of about %s s that was not found." % DecimalText.of(time)
	return ""


static func _miss(n: PackedFloat64Array) -> Vec2:
	var time := n[9]
	return Vec2.new(
		n[0] + n[6] * n[7] * time + 0.5 * n[4] * time * time - n[2],
		n[1] + n[6] * n[8] * time + 0.5 * n[5] * time * time - n[3]
	)
