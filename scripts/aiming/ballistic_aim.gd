class_name BallisticAim
extends RefCounted
## Aims a bullet that gravity pulls.
##
## Seen from the shooter, the target is at P + V t + a t²/2, and gravity carries the bullet by
## g t²/2. What is left for the shot itself is D(t) = P + V t + (a - g) t²/2, and the bullet flies
## s t in that time: it hits where |D(t)| = s t, and the direction is that of D.


## The shots from [param shooter] at a point that rests: the flat arc first, then the high one.
## Without gravity there is one. Empty where [param speed], in px/s, is less than
## [method least_speed], and where shooter and target are in one place.
static func at_fixed(shooter: Vec2, target: Vec2, gravity: Vec2, speed: float) -> Array[Aim]:
	if not Aim.can_shoot(speed):
		return []
	var way := target.minus(shooter)
	var shots: Array[Aim] = []
	for time in fixed_times(way, gravity, speed):
		var direction := way.minus(gravity.scaled(0.5 * time * time))
		shots.append(Aim.at(time, direction, target.copy()))
	return shots


## The same by the formula of the slide, for gravity straight down, in px/s²: the tangent of the
## angle above the level is (s² ± sqrt(s⁴ - g (g x² + 2 y s²))) / (g x), with y upwards. Straight up
## and down it divides by 0, and near the edge of what can be reached its digits cancel.
static func at_fixed_by_the_slide(
	shooter: Vec2, target: Vec2, gravity: float, speed: float
) -> Array[Aim]:
	var x := target.x - shooter.x
	var y := shooter.y - target.y
	var square := speed * speed
	var inside := square * square - gravity * (gravity * x * x + 2.0 * y * square)
	var shots: Array[Aim] = []
	if not inside >= 0.0:
		return shots
	for side: float in [-1.0, 1.0]:
		var tangent := (square + side * sqrt(inside)) / (gravity * x)
		var direction := Vec2.new(signf(x), -signf(x) * tangent).normalized()
		shots.append(Aim.at(x / (speed * direction.x), direction, target.copy()))
	return shots


## The shots that hit [param target] within [param longest] seconds, the earliest first. Of a target
## with a radius only the earliest touch is a shot; where both touch already, its time is 0. The
## shooter's own velocity is left out: subtract it from the target's.
static func at_moving(
	shooter: Vec2, target: AimTarget, gravity: Vec2, speed: float, longest: float
) -> Array[Aim]:
	if not Aim.can_shoot(speed):
		return []
	var way := target.position.minus(shooter)
	var bend := target.acceleration.minus(gravity)
	if way.length() <= target.radius:
		return [Aim.at(0.0, way, target.position.copy())]
	var shots: Array[Aim] = []
	for time in moving_times(way, target.velocity, bend, speed, target.radius, longest):
		var moved := target.velocity.scaled(time).plus(bend.scaled(0.5 * time * time))
		shots.append(Aim.at(time, way.plus(moved), target.position_after(time)))
		if target.radius > 0.0:
			break
	return shots


## The least speed, in px/s, that reaches [param target]: s² = |g| |P| - g·P. Its direction halves
## the angle between the way to the target and the direction against gravity.
static func least_speed(shooter: Vec2, target: Vec2, gravity: Vec2) -> float:
	var way := target.minus(shooter)
	var length := way.length()
	return sqrt(length) * _least_speed(way.normalized(), gravity)


## The times of flight to a point at [param way] that rests, in seconds: none, one or two. From
## |P - g t²/2| = s t follows (g/2)² u² - (s² + g·P) u + P² = 0 for u = t².
##
## Neither a tangent nor a division by x: straight up and down are no special case. Near the edge of
## what can be reached the digits of s² - least² would cancel; its two factors keep them.
static func fixed_times(way: Vec2, gravity: Vec2, speed: float) -> PackedFloat64Array:
	var length := way.length()
	if length == 0.0:
		return []
	# Counted in the length of the way and in the time that it takes without gravity.
	var unit := length / speed
	var p := way.divided(length)
	var g := gravity.scaled(unit / speed)
	var pull := g.length()
	var least := _least_speed(p, g)
	if least > 1.0:
		return []
	var b := 1.0 + g.dot(p)
	var e := b + sqrt((1.0 - least) * (1.0 + least) * (b + pull))
	var found: PackedFloat64Array = [sqrt(2.0 / e) * unit]
	if pull > 0.0:
		found.append(sqrt(2.0 * e) / pull * unit)
	return found


## The times within ([code]0[/code], [param longest]] at which |D(t)| = R + s t, in order; see the
## class for D, whose acceleration is [param bend]. [param way] is longer than [param radius].
static func moving_times(
	way: Vec2, velocity: Vec2, bend: Vec2, speed: float, radius: float, longest: float
) -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	if bend.x == 0.0 and bend.y == 0.0:
		for time in LeadAim.times(way, velocity, speed, radius):
			if time <= longest:
				found.append(time)
		return found
	var length := way.length()
	var unit := length / maxf(velocity.length(), speed)
	var p := way.divided(length)
	var v := velocity.scaled(unit / length)
	var a := bend.scaled(unit / length * unit)
	var s := speed * unit / length
	var r := radius / length
	var quartic: PackedFloat64Array = [
		(length - radius) / length * (1.0 + r),
		2.0 * (p.dot(v) - s * r),
		v.length_squared() + a.dot(p) - s * s,
		a.dot(v),
		0.25 * a.length_squared(),
	]
	# The same as the quartic, but nothing in it cancels near a zero.
	var too_far := func(t: float) -> float:
		var x := p.x + (v.x + 0.5 * a.x * t) * t
		var y := p.y + (v.y + 0.5 * a.y * t) * t
		var distance := sqrt(x * x + y * y)
		return (distance - r - s * t) * (distance + r + s * t)
	var last := longest / unit
	var turning := RealRoots.of_polynomial(RealRoots.derivative(quartic), 0.0, last)
	for time in RealRoots.of_function(too_far, turning, 0.0, last):
		found.append(time * unit)
	return found


# For a way of length 1. Below the shooter the digits of |g| - g·p would cancel.
static func _least_speed(p: Vec2, gravity: Vec2) -> float:
	var down := gravity.dot(p)
	var pull := gravity.length()
	if down <= 0.0:
		return sqrt(pull - down)
	return absf(gravity.cross(p)) / sqrt(pull + down)
