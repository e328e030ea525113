class_name TimedAim
extends RefCounted
## Waits with a fixed barrel for the moment to fire: the bullet's place and the target's are to be
## the same at the same time. The earliest moment that is not over is the answer.

## A shot later than this, in seconds, does not count.
const LONGEST := 60.0


## When to fire at a target on a line. [param muzzle] is where the bullet starts, [param bullet] its
## velocity then, in px/s; [param gravity] pulls it.
##
## With P from the muzzle to the target, W the bullet's velocity and v the target's, they meet where
## W f + g f²/2 = P + v (fire + f). Across v, the time of firing drops out; what is left is an
## equation for the flight f alone. The last step of Newton's method makes both equations hold to
## the last bits, also where the two ways are nearly parallel.
static func at_line(
	muzzle: Vec2, bullet: Vec2, gravity: Vec2, target: Vec2, velocity: Vec2
) -> TimedShot:
	var p := target.minus(muzzle)
	var across := bullet.cross(velocity)
	var bend := 0.5 * gravity.cross(velocity)
	if across == 0.0 and bend == 0.0:
		return TimedShot.miss(TimedShot.Outcome.PARALLEL)
	var shots: Array[TimedShot] = []
	for flight in _later(Quadratic.roots(bend, across, -p.cross(velocity))):
		var way := _flown(p.negated(), bullet, gravity, flight)
		var met := way.dot(velocity) / velocity.length_squared()
		var shot := TimedShot.at(met - flight, flight)
		var miss := way.minus(velocity.scaled(shot.fire + shot.flight))
		_mend(shot, miss, bullet.plus(gravity.scaled(flight)), velocity)
		shots.append(shot)
	return _earliest(shots)


## When to fire at a target on a circle about [param centre]: at the time 0 it is at the angle
## [param phase], in radians, and turns by [param turn] radians a second, not 0. Both are clockwise
## on screen.
##
## The bullet crosses the circle at flights f that do not depend on when it is fired; then the
## target has to be there. A target that does not turn is an error.
static func at_circle(
	muzzle: Vec2,
	bullet: Vec2,
	gravity: Vec2,
	centre: Vec2,
	radius: float,
	phase: float,
	turn: float
) -> TimedShot:
	if turn == 0.0 or not is_finite(turn):
		push_error("A target on a circle must turn, by a finite number of rad/s, not by %s." % turn)
		return TimedShot.miss(TimedShot.Outcome.NO_CROSSING)
	var shots: Array[TimedShot] = []
	var from := muzzle.minus(centre)
	for flight in _later(_crossings(from, bullet, gravity, radius)):
		var there := _flown(from, bullet, gravity, flight)
		var period := TAU / absf(turn)
		var met := (there.angle_radians() - phase) / turn
		var shot := TimedShot.at(fposmod(met - flight, period), flight)
		var out := Vec2.unit_radians(phase + turn * (shot.fire + flight))
		var miss := there.minus(out.scaled(radius))
		var target_velocity := Vec2.new(-out.y, out.x).scaled(radius * turn)
		_mend(shot, miss, bullet.plus(gravity.scaled(flight)), target_velocity)
		shots.append(shot)
	return _earliest(shots)


## The same as [method at_line] by the formulas of the slide, without gravity: the flight is
## (P × v) / (W × v), and the moment to fire is (P × (W - v)) / (W × v). Where both ways are nearly
## parallel the digits of W × v cancel, and both times lose as many.
static func at_line_by_the_slide(
	muzzle: Vec2, bullet: Vec2, target: Vec2, velocity: Vec2
) -> TimedShot:
	var p := target.minus(muzzle)
	var across := bullet.cross(velocity)
	if across == 0.0:
		return TimedShot.miss(TimedShot.Outcome.PARALLEL)
	var fire := p.cross(bullet.minus(velocity)) / across
	return _earliest([TimedShot.at(fire, p.cross(velocity) / across)])


## The same as [method at_circle] by the formulas of the slide, without gravity: the quadratic
## formula (-b ± sqrt(b² - a c)) / a for the flights, and the angle there for the moment. Where the
## bullet grazes the circle, and where it starts close to it, the digits cancel.
static func at_circle_by_the_slide(
	muzzle: Vec2, bullet: Vec2, centre: Vec2, radius: float, phase: float, turn: float
) -> TimedShot:
	var from := muzzle.minus(centre)
	var a := bullet.length_squared()
	var b := from.dot(bullet)
	var root := sqrt(b * b - a * (from.length_squared() - radius * radius))
	var shots: Array[TimedShot] = []
	for side: float in [-1.0, 1.0]:
		var flight := (-b + side * root) / a
		var there := from.plus(bullet.scaled(flight))
		var met := (there.angle_radians() - phase) / turn
		shots.append(TimedShot.at(fposmod(met - flight, TAU / absf(turn)), flight))
	return _earliest(shots)


## Half of the time, in seconds, within which a shot at a target on a line still hits where bullet
## and target have [param radius] together, without gravity: R |W - v| / |v × W|. INF where both
## ways are parallel.
static func window(bullet: Vec2, velocity: Vec2, radius: float) -> float:
	return radius * bullet.distance_to(velocity) / absf(velocity.cross(bullet))


static func _earliest(shots: Array[TimedShot]) -> TimedShot:
	var best := TimedShot.miss(TimedShot.Outcome.NO_CROSSING)
	for shot in shots:
		if not shot.flight > 0.0:
			continue
		if not (shot.fire >= 0.0 and shot.fire <= LONGEST):
			if not best.hit:
				best.outcome = TimedShot.Outcome.NOT_IN_TIME
		elif not best.hit or shot.fire < best.fire:
			best = shot
	return best


static func _flown(from: Vec2, bullet: Vec2, gravity: Vec2, flight: float) -> Vec2:
	var fallen := gravity.scaled(0.5 * flight * flight)
	return from.plus(bullet.scaled(flight)).plus(fallen)


# Those of these flights that are later than the shot. They are sorted out before the last step of
# Newton's method: of a muzzle that is on the way of the target it would make a flight of 1e-14 s.
static func _later(flights: PackedFloat64Array) -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	for flight in flights:
		if flight > 0.0:
			found.append(flight)
	return found


# The flights after which the bullet is on the circle.
static func _crossings(
	from: Vec2, bullet: Vec2, gravity: Vec2, radius: float
) -> PackedFloat64Array:
	var distance := from.length()
	var outside := (distance - radius) * (distance + radius)
	if gravity.x == 0.0 and gravity.y == 0.0:
		return Quadratic.roots(bullet.length_squared(), 2.0 * from.dot(bullet), outside)
	var quartic: PackedFloat64Array = [
		outside,
		2.0 * from.dot(bullet),
		bullet.length_squared() + from.dot(gravity),
		bullet.dot(gravity),
		0.25 * gravity.length_squared(),
	]
	var too_far := func(flight: float) -> float:
		var place := _flown(from, bullet, gravity, flight).length()
		return (place - radius) * (place + radius)
	# No root is larger (Cauchy's bound).
	var last := 0.0
	for coefficient in quartic:
		last = maxf(last, 1.0 + absf(coefficient / quartic[-1]))
	var turning := RealRoots.of_polynomial(RealRoots.derivative(quartic), 0.0, last)
	return RealRoots.of_function(too_far, turning, 0.0, last)


# One step of Newton's method for the two equations of x and y: by how much the bullet misses the
# target, and how fast both move then.
static func _mend(
	shot: TimedShot, miss: Vec2, bullet_velocity: Vec2, target_velocity: Vec2
) -> void:
	var area := bullet_velocity.cross(target_velocity)
	if area != 0.0:
		shot.fire -= miss.cross(bullet_velocity.minus(target_velocity)) / area
		shot.flight -= miss.cross(target_velocity) / area
