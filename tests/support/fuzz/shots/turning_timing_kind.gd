class_name TurningTimingKind
extends ShotKind
## The moment to fire a barrel that turns all the time at a target on a line: ball 0 is the bullet
## as it would be fired at the time 0, and [member FuzzWorld.seconds] is the time of a whole turn.


func _init() -> void:
	name = "shots_turning"


func world_of(number: int) -> FuzzWorld:
	var rng := random(number)
	var made := FuzzWorld.new()
	made.seconds = rng.randf_range(2.0, 30.0)
	var bullet := Ball.new(place(rng), POINT, vector(rng, 50.0, 600.0))
	var velocity := vector(rng, 0.0, 0.9 * bullet.velocity.length())
	made.balls = [bullet, Ball.new(place(rng), POINT, velocity)]
	return made


func can_be_asked(world: FuzzWorld) -> bool:
	return super(world) and world.balls[0].velocity.length() > world.balls[1].velocity.length()


func problem_of_shots(world: FuzzWorld) -> String:
	var muzzle := world.balls[0].position
	var speed := world.balls[0].velocity.length()
	var angle := world.balls[0].velocity.angle_radians()
	var turn := TAU / world.seconds
	var target := AimTarget.new(world.balls[1].position, world.balls[1].velocity)
	var shot := TurningBarrel.new(muzzle, angle, turn, speed, target).first()
	var numbers: PackedFloat64Array = [
		muzzle.x,
		muzzle.y,
		angle,
		turn,
		speed,
		target.position.x,
		target.position.y,
		target.velocity.x,
		target.velocity.y,
		shot.fire,
		shot.flight
	]
	var found := _earlier(numbers, shot)
	if found or not shot.hit:
		return found
	var barrel := Vec2.unit_radians(angle + turn * shot.fire).scaled(speed)
	var place_then := FiredShot.new(muzzle, barrel).place_after(shot.flight)
	var there := target.position_after(shot.fire + shot.flight)
	return problem_of_flight(place_then.minus(there), numbers, _miss)


# Seen from the muzzle, a bullet that is fired now flies beside the target, on one side or on the
# other. Where that changes it hits, or it flies away from the target.
func _earlier(n: PackedFloat64Array, shot: TimedShot) -> String:
	var last := shot.fire if shot.hit else TimedAim.LONGEST
	var beside := func(fire: float) -> float: return _relative(n, fire).cross(_place(n, fire))
	for fire: float in zeros(beside, moments(last * (1.0 - 1e-9))):
		var is_ahead := _relative(n, fire).dot(_place(n, fire)) > 0.0
		if is_ahead and fire > 1e-6 and fire < last - 1e-6 * (1.0 + last):
			return "A shot after %s s would hit, too." % DecimalText.of(fire)
	return ""


# The target's place when the shot is fired, as the muzzle sees it.
static func _place(n: PackedFloat64Array, fire: float) -> Vec2:
	return Vec2.new(n[5] + n[7] * fire - n[0], n[6] + n[8] * fire - n[1])


# The bullet's velocity, as the target sees it.
static func _relative(n: PackedFloat64Array, fire: float) -> Vec2:
	return Vec2.unit_radians(n[2] + n[3] * fire).scaled(n[4]).minus(Vec2.new(n[7], n[8]))


static func _miss(n: PackedFloat64Array) -> Vec2:
	var angle := n[2] + n[3] * n[9]
	var way := n[4] * n[10]
	var time := n[9] + n[10]
	return Vec2.new(
		n[0] + cos(angle) * way - n[5] - n[7] * time, n[1] + sin(angle) * way - n[6] - n[8] * time
	)
