class_name MovingShotKind
extends ShotKind
## Shots under gravity at a target that moves; where there is a third ball, its velocity is the
## acceleration of the target. Only shots of at most [member FuzzWorld.seconds] count.


func _init() -> void:
	name = "shots_moving"


func world_of(number: int) -> FuzzWorld:
	var rng := random(number)
	var made := FuzzWorld.new()
	made.gravity = vector(rng, 0.0, 600.0)
	made.seconds = rng.randf_range(2.0, 20.0)
	var bullet := Ball.new(place(rng), POINT, vector(rng, 50.0, 800.0))
	var radius := POINT if rng.randf() < 0.6 else rng.randf_range(1.0, 40.0)
	made.balls = [bullet, Ball.new(place(rng), radius, vector(rng, 0.0, 400.0))]
	if rng.randf() < 0.3:
		var pull := made.gravity if rng.randf() < 0.3 else vector(rng, 0.0, 300.0)
		made.balls.append(Ball.new(Vec2.zero(), POINT, pull))
	if rng.randf() < 0.1:
		move_far(made, rng)
	return made


func problem_of_shots(world: FuzzWorld) -> String:
	var shooter := world.balls[0].position
	var speed := world.balls[0].velocity.length()
	var there := world.balls[1]
	var pull := world.balls[2].velocity if world.balls.size() > 2 else Vec2.zero()
	var target := AimTarget.new(there.position, there.velocity, pull, radius_of(there))
	var shots := BallisticAim.at_moving(shooter, target, world.gravity, speed, world.seconds)
	if shots.size() == 1 and shots[0].time == 0.0:
		return ""
	var found := _other(world, target, shots)
	for shot: Aim in shots:
		found = found if found else _problem_of_shot(world, target, shot)
	return found


func _problem_of_shot(world: FuzzWorld, target: AimTarget, aim: Aim) -> String:
	var shooter := world.balls[0].position
	var speed := world.balls[0].velocity.length()
	var shot := FiredShot.new(shooter, aim.direction.scaled(speed), world.gravity)
	var reach := aim.direction.scaled(target.radius)
	var missed := shot.place_after(aim.time).plus(reach).minus(target.position_after(aim.time))
	var numbers: PackedFloat64Array = [
		shooter.x,
		shooter.y,
		target.position.x,
		target.position.y,
		target.velocity.x,
		target.velocity.y,
		speed,
		target.radius,
		aim.direction.x,
		aim.direction.y,
		aim.time,
		world.gravity.x,
		world.gravity.y,
		target.acceleration.x,
		target.acceleration.y
	]
	return problem_of_flight(missed, numbers, _miss)


# Each time at which the bullet could be at the target is that of a shot; of a target with a radius
# only the first one is.
func _other(world: FuzzWorld, target: AimTarget, shots: Array[Aim]) -> String:
	var shooter := world.balls[0].position
	var speed := world.balls[0].velocity.length()
	var gap := func(time: float) -> float:
		var needed := target.position_after(time).minus(shooter)
		needed.subtract(world.gravity.scaled(0.5 * time * time))
		return needed.length() - target.radius - speed * time
	for time: float in zeros(gap, moments(world.seconds)):
		var nearest := INF
		for shot: Aim in shots:
			nearest = minf(nearest, absf(shot.time - time))
		if nearest > 1e-5 * (1.0 + time):
			return "There is a shot of %s s that was not found." % DecimalText.of(time)
		if target.radius > 0.0:
			break
	return ""


static func _miss(n: PackedFloat64Array) -> Vec2:
	var time := n[10]
	var flown_way := n[6] * time + n[7]
	var half := 0.5 * time * time
	return Vec2.new(
		n[0] + flown_way * n[8] + half * (n[11] - n[13]) - n[2] - n[4] * time,
		n[1] + flown_way * n[9] + half * (n[12] - n[14]) - n[3] - n[5] * time
	)
