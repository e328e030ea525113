class_name TimedQuestion
extends RefCounted
## When a barrel fires at a target that passes: what is asked, and by how much a shot misses.

## The muzzle, in pixels.
var muzzle: Vec2
## The barrel's angle at the time 0, in radians, clockwise on screen.
var angle: float
## By how much it turns, in radians a second; 0 where it is fixed.
var turn := 0.0
## The bullet's speed, in px/s.
var speed: float
## The target where it is on a line. For one on a circle its position is the centre.
var target: AimTarget
## The radius of the target's circle, in pixels; 0 where it is on a line.
var circle_radius := 0.0
## Where it is on the circle at the time 0, in radians.
var phase := 0.0
## By how much it turns, in radians a second.
var circle_turn := 0.0
## The velocity of a bullet from a fixed barrel, in px/s.
var bullet: Vec2
## The answer of the aiming code.
var careful: TimedShot


## By how much a shot after [param fire] seconds misses, in pixels: the least distance of the
## centres.
func miss(fire: float) -> float:
	var longest := 2.0 * careful.flight + 1.0
	return _approach(DoubleDouble.from_float(fire)).least_distance(longest, careful.flight)


## The same for a result of the aiming code; NAN for one without a hit.
func miss_of(shot: TimedShot) -> float:
	return miss(shot.fire) if shot.hit else NAN


## Sets [member bullet] and [member careful] to what follows from the rest.
func solve() -> void:
	bullet = Vec2.unit_radians(angle).scaled(speed)
	careful = answer()


## The answer of the aiming code; [member bullet] must be set.
func answer() -> TimedShot:
	var centre := target.position
	if turn:
		return TurningBarrel.new(muzzle, angle, turn, speed, target).first()
	if circle_radius:
		return TimedAim.at_circle(
			muzzle, bullet, Vec2.zero(), centre, circle_radius, phase, circle_turn
		)
	return TimedAim.at_line(muzzle, bullet, Vec2.zero(), target.position, target.velocity)


# From the moment of the shot on.
func _approach(fire: DoubleDouble) -> ExactApproach:
	var velocity := ExactVector.from_vec2(target.velocity)
	var place := ExactVector.between(target.position, muzzle).minus(velocity.scaled(fire))
	var shot := ExactVector.from_vec2(bullet)
	if turn:
		var barrel := fire.times(DoubleDouble.from_float(turn))
		var direction := ExactAngle.unit(barrel.plus(DoubleDouble.from_float(angle)))
		shot = direction.scaled(DoubleDouble.from_float(speed))
	var approach := ExactApproach.new(place, shot.minus(velocity))
	if circle_radius:
		var turned := fire.times(DoubleDouble.from_float(circle_turn))
		approach.set_circle(circle_radius, turned.plus(DoubleDouble.from_float(phase)), circle_turn)
	return approach
