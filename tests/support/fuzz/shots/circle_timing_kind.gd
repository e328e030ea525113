class_name CircleTimingKind
extends ShotKind
## The moment to fire a fixed barrel at a target on a circle: ball 0 is the bullet as it is fired,
## ball 1 the target, ball 2 the centre of its circle.

# Seconds. Later crossings are not looked for.
const _LONGEST := 20.0


func _init() -> void:
	name = "shots_timed_circle"


func world_of(number: int) -> FuzzWorld:
	var rng := random(number)
	var made := FuzzWorld.new()
	if rng.randf() < 0.5:
		made.gravity = vector(rng, 10.0, 400.0)
	var centre := place(rng)
	var out := vector(rng, 20.0, 250.0)
	var turn := rng.randf_range(0.2, 3.0) * (1.0 if rng.randf() < 0.5 else -1.0)
	var velocity := Vec2.new(-out.y, out.x).scaled(turn)
	var bullet := Ball.new(place(rng), POINT, vector(rng, 50.0, 600.0))
	if rng.randf() < 0.8:
		# The bullet comes to the circle.
		var way := bullet.velocity.scaled(rng.randf_range(0.1, 2.0))
		centre = bullet.position.plus(way).minus(Vec2.random_unit(rng).scaled(out.length()))
	made.balls = [bullet, Ball.new(centre.plus(out), POINT, velocity), Ball.new(centre, POINT)]
	if rng.randf() < 0.1:
		move_far(made, rng)
	return made


func can_be_asked(world: FuzzWorld) -> bool:
	if not super(world) or world.balls.size() < 3:
		return false
	var out := world.balls[1].position.minus(world.balls[2].position)
	return out.length() > 1.0 and absf(out.cross(world.balls[1].velocity)) > 1e-3


func problem_of_shots(world: FuzzWorld) -> String:
	var muzzle := world.balls[0].position
	var bullet := world.balls[0].velocity
	var centre := world.balls[2].position
	var out := world.balls[1].position.minus(centre)
	var phase := out.angle_radians()
	var radius := out.length()
	var turn := out.cross(world.balls[1].velocity) / out.length_squared()
	var gravity := world.gravity
	var shot := TimedAim.at_circle(muzzle, bullet, gravity, centre, radius, phase, turn)
	var numbers: PackedFloat64Array = [
		muzzle.x,
		muzzle.y,
		bullet.x,
		bullet.y,
		gravity.x,
		gravity.y,
		centre.x,
		centre.y,
		radius,
		phase,
		turn,
		shot.fire,
		shot.flight
	]
	var found := _earlier(numbers, shot)
	if found or not shot.hit:
		return found
	var place_then := FiredShot.new(muzzle, bullet, gravity).place_after(shot.flight)
	var angle := phase + turn * (shot.fire + shot.flight)
	var missed := place_then.minus(centre).minus(Vec2.unit_radians(angle).scaled(radius))
	return problem_of_flight(missed, numbers, _miss)


# Where the bullet crosses the circle, and when the target is there next.
func _earlier(n: PackedFloat64Array, shot: TimedShot) -> String:
	var flown_to := func(flight: float) -> Vec2:
		var half := 0.5 * flight * flight
		return Vec2.new(
			n[0] - n[6] + n[2] * flight + n[4] * half, n[1] - n[7] + n[3] * flight + n[5] * half
		)
	var outside := func(flight: float) -> float:
		var there: Vec2 = flown_to.call(flight)
		return there.length() - n[8]
	for flight: float in zeros(outside, moments(_LONGEST)):
		var there: Vec2 = flown_to.call(flight)
		var period := TAU / absf(n[10])
		var fire := fposmod((there.angle_radians() - n[9]) / n[10] - flight, period)
		var last := shot.fire if shot.hit else TimedAim.LONGEST
		# A grazing bullet is on the circle for a while.
		if fire > 1e-4 and fire < last - 1e-4 and flight > 1e-6:
			return "A shot after %s s would hit, too." % DecimalText.of(fire)
	return ""


static func _miss(n: PackedFloat64Array) -> Vec2:
	var flight := n[12]
	var half := 0.5 * flight * flight
	var angle := n[9] + n[10] * (n[11] + flight)
	return Vec2.new(
		n[0] + n[2] * flight + n[4] * half - n[6] - n[8] * cos(angle),
		n[1] + n[3] * flight + n[5] * half - n[7] - n[8] * sin(angle)
	)
