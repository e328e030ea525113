class_name LeadShotKind
extends ShotKind
## Shots ahead of a target that moves on a line, without gravity.

# Seconds. A shot that takes longer is not looked for.
const _LONGEST := 1000.0
# Pixels. A shot that goes farther leaves the event world: speeds that are equal but for the last
# digits meet after as long as one likes.
const _FARTHEST := 0.01 * WorldLimits.LARGEST


func _init() -> void:
	name = "shots_lead"


func world_of(number: int) -> FuzzWorld:
	var rng := random(number)
	var made := FuzzWorld.new()
	var bullet := Ball.new(place(rng), POINT, vector(rng, 20.0, 600.0))
	var speed := bullet.velocity.length()
	var velocity := vector(rng, 0.0, 400.0)
	match rng.randi() % 8:
		0:
			velocity = Vec2.zero()
		1:
			velocity = vector(rng, speed, speed)
		2:
			var nearly := 1.0 + 10.0 ** rng.randf_range(-15.0, -3.0) * signf(rng.randf() - 0.5)
			velocity = Vec2.random_unit(rng).scaled(speed * nearly)
	var radius := POINT if rng.randf() < 0.5 else rng.randf_range(1.0, 40.0)
	made.balls = [bullet, Ball.new(place(rng), radius, velocity)]
	if rng.randf() < 0.1:
		move_far(made, rng)
	return made


func problem_of_shots(world: FuzzWorld) -> String:
	var shooter := world.balls[0].position
	var speed := world.balls[0].velocity.length()
	var there := world.balls[1]
	var target := AimTarget.new(there.position, there.velocity, Vec2.zero(), radius_of(there))
	var aim := LeadAim.first(shooter, target, speed)
	if aim.hit and aim.time == 0.0:
		return (
			"" if shooter.distance_to(target.position) <= target.radius else "Nothing touches yet."
		)
	var found := _earlier(shooter, target, speed, aim.time if aim.hit else _LONGEST)
	if found or not aim.hit or aim.time * speed > _FARTHEST:
		return found
	var shot := FiredShot.new(shooter, aim.direction.scaled(speed))
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
		aim.time
	]
	return problem_of_flight(missed, numbers, _miss)


# Whether the bullet could touch before that time, wherever it is shot.
func _earlier(shooter: Vec2, target: AimTarget, speed: float, last: float) -> String:
	var size := shooter.length() + target.position.length() + target.radius
	for time: float in moments(last * (1.0 - 1e-9)):
		var distance := target.position_after(time).distance_to(shooter)
		var gap := distance - target.radius - speed * time
		var sizes: PackedFloat64Array = [size, target.velocity.length() * time, speed * time]
		if gap < -rounding(sizes):
			return "A shot could hit after %s s already." % DecimalText.of(time)
	return ""


static func _miss(n: PackedFloat64Array) -> Vec2:
	var flown_way := n[6] * n[10] + n[7]
	return Vec2.new(
		n[0] + flown_way * n[8] - n[2] - n[4] * n[10], n[1] + flown_way * n[9] - n[3] - n[5] * n[10]
	)
