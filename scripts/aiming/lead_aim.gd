class_name LeadAim
extends RefCounted
## Aims ahead of a moving target, for a bullet of constant speed.
##
## Seen from the shooter, the target is at P and moves with V. After t seconds the bullet is
## somewhere on a circle of radius s t, and it touches the target where |P + V t| = R + s t.
## Squared, that is a t² + 2 b t + c = 0 with a = V² - s², b = P·V - s R and c = P² - R².


## The earliest shot from [param shooter] that hits [param target], whose acceleration does not
## count. The bullet has [param speed], in px/s and above 0, relative to the shooter, and takes the
## shooter's own velocity along. Where both touch already, the time is 0.
static func first(
	shooter: Vec2, target: AimTarget, speed: float, shooter_velocity := Vec2.zero()
) -> Aim:
	if not Aim.can_shoot(speed):
		return Aim.miss(Aim.Outcome.OUT_OF_REACH)
	var way := target.position.minus(shooter)
	if way.length() <= target.radius:
		return Aim.at(0.0, way, target.position.copy())
	var relative := target.velocity.minus(shooter_velocity)
	var found := times(way, relative, speed, target.radius)
	if found.is_empty():
		return Aim.miss(Aim.Outcome.OUTRUN)
	var direction := way.plus(relative.scaled(found[0]))
	var place := target.position.plus(target.velocity.scaled(found[0]))
	return Aim.at(found[0], direction, place)


## The same by the quadratic formula of the slide, t = (-b ± sqrt(b² - a c)) / a. Where the speeds
## are nearly equal its digits cancel, and where they are equal it divides by 0 and finds nothing.
static func first_by_the_slide(
	shooter: Vec2, target: AimTarget, speed: float, shooter_velocity := Vec2.zero()
) -> Aim:
	var p := target.position.minus(shooter)
	var v := target.velocity.minus(shooter_velocity)
	var a := v.length_squared() - speed * speed
	var b := p.dot(v) - speed * target.radius
	var c := p.length_squared() - target.radius * target.radius
	if c <= 0.0:
		return Aim.at(0.0, p, target.position.copy())
	var root := sqrt(b * b - a * c)
	var times_of_hit: Array[float] = [(-b - root) / a, (-b + root) / a]
	times_of_hit.sort()
	for time in times_of_hit:
		if time >= 0.0 and time < INF:
			var place := target.position.plus(target.velocity.scaled(time))
			return Aim.at(time, p.plus(v.scaled(time)), place)
	return Aim.miss(Aim.Outcome.OUTRUN)


## The times at which |P + V t| = R + s t, the earliest first: at most two, in seconds, none below
## 0. [param way] is P, longer than the radius R, [param velocity] V and [param speed] s > 0.
##
## Lengths are counted in P and speeds in the larger one, so that no square overflows. A target that
## is not faster has a up to 0: in the discriminant b² - a c nothing cancels. Else it would lose its
## digits where a shot grazes. (s P - R V)² - (P × V)² is the same number, and its two factors keep
## them.
static func times(way: Vec2, velocity: Vec2, speed: float, radius: float) -> PackedFloat64Array:
	var length := way.length()
	var fastest := maxf(velocity.length(), speed)
	var p := way.divided(length)
	var v := velocity.divided(fastest)
	var s := speed / fastest
	var r := radius / length
	# Not from the divided ones: equal speeds must give 0.
	var fast := velocity.length()
	var a := (fast - speed) / fastest * ((fast + speed) / fastest)
	var b := p.dot(v) - s * r
	var c := (length - radius) / length * (1.0 + r)
	var unit := length / fastest
	var found: PackedFloat64Array = []
	if a <= 0.0:
		var root := sqrt(b * b - a * c)
		var time := c / (root - b) if b <= 0.0 else (b + root) / absf(a)
		if time < INF:
			found.append(time * unit)
	elif b < 0.0:
		var k := p.scaled(s).minus(v.scaled(r)).length()
		var x := absf(p.cross(v))
		if k >= x:
			var root := sqrt((k - x) * (k + x))
			found = [c / (root - b) * unit, (root - b) / a * unit]
	return found
