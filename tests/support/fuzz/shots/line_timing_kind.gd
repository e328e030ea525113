class_name LineTimingKind
extends ShotKind
## The moment to fire a fixed barrel at a target on a line: ball 0 is the bullet as it is fired.


func _init() -> void:
	name = "shots_timed_line"


func world_of(number: int) -> FuzzWorld:
	var rng := random(number)
	var made := FuzzWorld.new()
	if rng.randf() < 0.5:
		made.gravity = vector(rng, 10.0, 400.0)
	var bullet := Ball.new(place(rng), POINT, vector(rng, 50.0, 600.0))
	var velocity := vector(rng, 5.0, 300.0)
	if rng.randf() < 0.1:
		# Nearly parallel.
		velocity = bullet.velocity.scaled(rng.randf_range(-1.0, 1.0))
		velocity.rotate_radians(10.0 ** rng.randf_range(-9.0, -2.0))
	var target := Ball.new(place(rng), POINT, velocity)
	if rng.randf() < 0.8:
		# It comes at some time to where the bullet can be.
		var flight := rng.randf_range(0.1, 2.0)
		target.position = bullet.position.plus(bullet.velocity.scaled(flight))
		target.position.add(made.gravity.scaled(0.5 * flight * flight))
		target.position.subtract(velocity.scaled(flight + rng.randf_range(0.0, 20.0)))
	made.balls = [bullet, target]
	if rng.randf() < 0.1:
		move_far(made, rng)
	return made


func can_be_asked(world: FuzzWorld) -> bool:
	return super(world) and world.balls[1].velocity.length() > 0.0


func problem_of_shots(world: FuzzWorld) -> String:
	var muzzle := world.balls[0].position
	var bullet := world.balls[0].velocity
	var target := world.balls[1]
	var gravity := world.gravity
	var shot := TimedAim.at_line(muzzle, bullet, gravity, target.position, target.velocity)
	var found := _earlier(world, shot)
	if found or not shot.hit:
		return found
	var place_then := FiredShot.new(muzzle, bullet, gravity).place_after(shot.flight)
	var there := AimTarget.new(target.position, target.velocity)
	var missed := place_then.minus(there.position_after(shot.fire + shot.flight))
	var numbers: PackedFloat64Array = [
		muzzle.x,
		muzzle.y,
		bullet.x,
		bullet.y,
		gravity.x,
		gravity.y,
		target.position.x,
		target.position.y,
		target.velocity.x,
		target.velocity.y,
		shot.fire,
		shot.flight
	]
	return problem_of_flight(missed, numbers, _miss)


# Where the bullet crosses the target's line, and when the target is there.
func _earlier(world: FuzzWorld, shot: TimedShot) -> String:
	var from := world.balls[0].position.minus(world.balls[1].position)
	var bullet := world.balls[0].velocity
	var velocity := world.balls[1].velocity
	var flown_to := func(flight: float) -> Vec2:
		return from.plus(bullet.scaled(flight)).plus(world.gravity.scaled(0.5 * flight * flight))
	var beside := func(flight: float) -> float:
		var there: Vec2 = flown_to.call(flight)
		return there.cross(velocity)
	for flight: float in zeros(beside, moments(TimedAim.LONGEST)):
		var there: Vec2 = flown_to.call(flight)
		var fire := there.dot(velocity) / velocity.length_squared() - flight
		# A hair from what counts, or from a touch of both ways, it need not be found.
		var across := bullet.plus(world.gravity.scaled(flight)).normalized()
		var is_clear := absf(across.cross(velocity.normalized())) > 1e-6 and flight > 1e-9
		var slack := 1e-4 * (1.0 + absf(fire) + flight)
		var last := shot.fire if shot.hit else TimedAim.LONGEST
		if is_clear and fire > slack and fire < last - slack:
			return "A shot after %s s would hit, too." % DecimalText.of(fire)
	return ""


static func _miss(n: PackedFloat64Array) -> Vec2:
	var flight := n[11]
	var time := n[10] + flight
	var half := 0.5 * flight * flight
	return Vec2.new(
		n[0] + n[2] * flight + n[4] * half - n[6] - n[8] * time,
		n[1] + n[3] * flight + n[5] * half - n[7] - n[9] * time
	)
