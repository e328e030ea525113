class_name TimedShotModel
extends LessonModel
## A barrel that does not follow its target: when to fire so that the bullet hits, and what other
## moments miss by.
##
## Pixels, seconds, y points down. Target and barrel move from time 0 on.

## How target and barrel move: the target on a line or on a circle while the barrel stands still; or
## the target on a line while the barrel turns.
enum Kind { LINE, CIRCLE, TURNING }
## How the drawing is built up. In WAIT and FIRE the right shot is flown, else that of the student.
enum Step { WATCH, CROSS, WAIT, WINDOW, FIRE }
## Why no moment hits: the target rests; both ways are parallel; the bullet does not cross the
## target's way, or not before the target has passed; it takes longer than
## [constant TimedShotCheck.LONGEST]; the bullet is not faster than the target; the barrel never
## points ahead as it should.
enum Reason { RESTS, PARALLEL, NO_CROSSING, TOO_LATE, TOO_LONG, TOO_SLOW, NEVER }

## Presets by their titles (source text): what each changes in the model's state.
const PRESETS: Dictionary[String, Dictionary] = {
	"Straight across":
	{
		kind = 0,
		muzzle = [0, 100],
		bullet = [0, -200],
		target = [-300, -100],
		velocity = [100, 0],
		radius = 10.0
	},
	"Aslant":
	{
		kind = 0,
		muzzle = [100, 100],
		bullet = [-120, -160],
		target = [-300, -100],
		velocity = [100, 0],
		radius = 10.0
	},
	"Too late":
	{
		kind = 0,
		muzzle = [0, 100],
		bullet = [0, -200],
		target = [-50, -100],
		velocity = [100, 0],
		radius = 10.0
	},
	"Parallel":
	{
		kind = 0,
		muzzle = [0, 100],
		bullet = [0, -200],
		target = [-100, 100],
		velocity = [0, -100],
		radius = 10.0
	},
	"Circle":
	{
		kind = 1,
		muzzle = [0, 150],
		bullet = [0, -200],
		target = [100, -50],
		centre = [0, -50],
		circling = 90.0,
		radius = 10.0
	},
	"Turning barrel":
	{
		kind = 2,
		muzzle = [0, 100],
		bullet = [-200, 0],
		target = [-300, -100],
		velocity = [100, 0],
		turning = 45.0,
		radius = 10.0
	},
}

## The arrows of velocities show so many seconds of them.
const ARROW_SECONDS := 0.5

# Moments that differ by less are the same, in seconds.
const _SAME := 1e-9
const _HALVINGS := 30
const _DOUBLINGS := 8
# How long a shot that never comes near is flown, in seconds.
const _FLIGHT := 2.0

## How target and barrel move.
var kind := Kind.LINE
## Where the bullet starts.
var muzzle := Vec2.new(0.0, 100.0)
## The bullet's velocity if it is fired at time 0, in px/s.
var bullet := Vec2.new(0.0, -200.0)
## The target's centre at time 0.
var target := Vec2.new(-300.0, -100.0)
## The target's velocity on a line, in px/s.
var velocity := Vec2.new(100.0, 0.0)
## The centre of the target's circle.
var centre := Vec2.new(0.0, -50.0)
## How fast it goes round there, in degrees per second, clockwise on screen.
var circling := 90.0
## How fast the barrel turns, in degrees per second, clockwise on screen.
var turning := 45.0
## The radii of bullet and target together.
var radius := 10.0
## When the student fires, in seconds.
var own_fire := 1.0
## The number of the mistake that is switched on; 0 for none.
var mistake := 0
## Seconds since the start.
var time := 0.0

# What the solver found, and for which numbers.
var _shot := TimedShot.miss(TimedShot.Outcome.NO_CROSSING)
var _solved_for: Array = []
# What was found for the same numbers, so that no frame searches: the window, when each step ends,
# and the moment of the mistake, NAN before it is found.
var _window: PackedFloat64Array = []
var _ends: Dictionary[Step, float] = {}
var _wrong_fire := NAN


## When to fire; read its `hit` first.
func shot() -> TimedShot:
	_solve()
	return _shot


## Whether any moment hits.
func has_shot() -> bool:
	return shot().hit


## Where the target is at the moment to fire that hits; null where no moment does.
func place_at_fire() -> Vec2:
	return target_after(shot().fire) if has_shot() else null


## Why no moment hits; only where none does.
func reason() -> Reason:
	match kind:
		Kind.TURNING:
			return Reason.TOO_SLOW if not _is_faster() else Reason.NEVER
		Kind.CIRCLE:
			return Reason.NO_CROSSING if flight() < 0.0 else Reason.TOO_LONG
	if velocity.length() == 0.0:
		return Reason.RESTS
	if shot().outcome == TimedShot.Outcome.PARALLEL:
		return Reason.PARALLEL
	if shot().outcome == TimedShot.Outcome.NO_CROSSING:
		return Reason.NO_CROSSING
	return Reason.TOO_LATE if time_to_crossing() < flight() else Reason.TOO_LONG


## Where the target is after so many seconds.
func target_after(seconds: float) -> Vec2:
	if kind != Kind.CIRCLE:
		return target.plus(velocity.scaled(seconds))
	var out := Vec2.unit_radians(phase() + Vec2.deg_to_rad(circling) * seconds)
	return centre.plus(out.scaled(circle_radius()))


## The velocity of the target then, in px/s.
func target_velocity(seconds: float) -> Vec2:
	if kind != Kind.CIRCLE:
		return velocity.copy()
	var out := target_after(seconds).minus(centre)
	return Vec2.new(-out.y, out.x).scaled(Vec2.deg_to_rad(circling))


## The radius of the target's circle, in pixels.
func circle_radius() -> float:
	return target.minus(centre).length()


## The angle of the target on its circle at time 0, in radians.
func phase() -> float:
	return target.minus(centre).angle_radians()


## The velocity of a bullet that is fired after so many seconds.
func bullet_velocity(fired: float) -> Vec2:
	if kind != Kind.TURNING:
		return bullet.copy()
	var turned := bullet.angle_radians() + Vec2.deg_to_rad(turning) * fired
	return Vec2.unit_radians(turned).scaled(bullet.length())


## Where a bullet is at the moment [param seconds] that was fired at [param fired].
func bullet_after(seconds: float, fired: float) -> Vec2:
	return muzzle.plus(bullet_velocity(fired).scaled(maxf(seconds - fired, 0.0)))


## n, the normal of the target's velocity: across it the target does not move.
func across() -> Vec2:
	return Vec2.new(-velocity.y, velocity.x)


## f: seconds from the shot until the bullet is where both ways cross; below 0 where they do not
## cross before it.
func flight() -> float:
	match kind:
		Kind.LINE:
			var closing := bullet.dot(across())
			return target.minus(muzzle).dot(across()) / closing if closing != 0.0 else -1.0
		Kind.CIRCLE:
			return shot().flight if has_shot() else _circle_pass(0.0).first_crossing()
	return shot().flight if has_shot() else -1.0


## X: where both ways cross; only where [method flight] is not below 0.
func crossing() -> Vec2:
	return muzzle.plus(bullet_velocity(shot().fire if has_shot() else 0.0).scaled(flight()))


## When the target is in X, in seconds; below 0 where it has passed.
func time_to_crossing() -> float:
	if kind == Kind.LINE:
		return crossing().minus(target).dot(velocity) / velocity.length_squared()
	return shot().fire + shot().flight if has_shot() else -1.0


## The moment at which the shot of [param step] is fired: the right one, or the student's.
func fire(step: Step) -> float:
	return shot().fire if flies_right(step) else own_fire


## Whether the right shot is flown at [param step].
func flies_right(step: Step) -> bool:
	return step in [Step.WAIT, Step.FIRE] and has_shot()


## How long everything moves at [param step], in seconds: until the bullet hits, or is nearest.
func end(step: Step) -> float:
	_solve()
	if not _ends.has(step):
		_ends[step] = _found_end(step)
	return _ends[step]


func _found_end(step: Step) -> float:
	var last := own_fire + clampf(miss_at(own_fire).moment, _FLIGHT, TimedShotCheck.LONGEST)
	if flies_right(step):
		last = shot().fire + shot().flight
	if compares(step):
		last = maxf(last, wrong_fire() + miss_at(wrong_fire()).moment)
	return last


## By how much a shot at the moment [param at] misses, as the event world flies it; its moment is
## counted from the shot on. [param computed] is the flight of one that was computed to hit.
func miss_at(at: float, computed: float = 0.0) -> ShotMiss:
	var leaving := bullet_velocity(at)
	if kind != Kind.CIRCLE:
		var there := AimTarget.new(target_after(at), velocity)
		var closing := leaving.distance_to(velocity)
		# They are nearest before one could have come to the other.
		var longest := there.position.distance_to(muzzle) / closing if closing > 0.0 else 0.0
		return ShotMiss.of(muzzle, leaving, Vec2.zero(), there, longest, computed)
	var place := func(seconds: float) -> Vec2: return target_after(at + seconds)
	var moments: PackedFloat64Array = [0.0, computed, _circle_pass(at).nearest_time()]
	return ShotMiss.nearest_of(FiredShot.new(muzzle, leaving), place, moments)


## The miss of the right shot; only where there is one.
func miss() -> ShotMiss:
	return miss_at(shot().fire, shot().flight)


## eps times the condition of the right shot, in pixels, over all its numbers: so far rounding alone
## may move it. Only where there is one.
func rounding() -> float:
	var numbers: PackedFloat64Array = [muzzle.x, muzzle.y, shot().fire, shot().flight]
	match kind:
		Kind.CIRCLE:
			numbers.append_array([centre.x, centre.y, circle_radius(), phase()])
			numbers.append_array([Vec2.deg_to_rad(circling), bullet.x, bullet.y])
			return TimedShotRounding.on_circle(numbers)
		Kind.TURNING:
			numbers.append_array([target.x, target.y, velocity.x, velocity.y, bullet.length()])
			numbers.append_array([bullet.angle_radians(), Vec2.deg_to_rad(turning)])
			return TimedShotRounding.of_turning(numbers)
	numbers.append_array([target.x, target.y, velocity.x, velocity.y, bullet.x, bullet.y])
	return TimedShotRounding.on_line(numbers)


## The first and the last moment of the firing window around the right shot, in seconds: every shot
## between hits. Only where there is a shot.
func window() -> PackedFloat64Array:
	_solve()
	if _window.is_empty():
		_window = [maxf(shot().fire - _half_window(-1.0), 0.0), shot().fire + _half_window(1.0)]
	return _window


## Half of the firing window of a target on a line, in seconds, by the formula; only where there is
## a shot.
func half_window() -> float:
	return TimedAim.window(bullet_velocity(shot().fire), velocity, radius)


## The moment to fire to which the mistake that is switched on leads; only where there is a shot. A
## turning barrel fires when it points at the target itself.
func wrong_fire() -> float:
	_solve()
	if is_nan(_wrong_fire):
		_wrong_fire = _found_wrong_fire()
	return _wrong_fire


func _found_wrong_fire() -> float:
	if kind == Kind.TURNING and mistake == TimedShotMistakes.IN_FRONT:
		var seen := _barrel(1e6 * (1.0 + velocity.length())).first(TimedShotCheck.LONGEST)
		return seen.fire if seen.hit else shot().fire
	return TimedShotMistakes.fire(mistake, shot())


## Half of the window, in seconds, without the bullet's motion; only where there is a shot.
func plain_half_window() -> float:
	return TimedShotMistakes.half_window(radius, target_velocity(shot().fire + shot().flight))


## Whether the mistake that is switched on leads to another moment, or to another window.
func mistake_shows() -> bool:
	if mistake == 0 or not has_shot():
		return false
	if mistake != TimedShotMistakes.BULLET_FORGOTTEN:
		return absf(wrong_fire() - shot().fire) > _SAME
	return kind == Kind.LINE and half_window() - plain_half_window() > _SAME * half_window()


## Whether the shot of the mistake is flown beside the right one at [param step].
func compares(step: Step) -> bool:
	var is_of_moment := mistake != TimedShotMistakes.BULLET_FORGOTTEN
	return is_of_moment and step in [Step.WAIT, Step.FIRE] and mistake_shows()


## Takes a typed number by its name in the formula lines. "" if it could be taken; else one sentence
## with the value and what is allowed.
func enter(name_in_line: String, value: float) -> String:
	var changed := to_dictionary()
	var places: Dictionary[String, Array] = {
		"sx": ["muzzle", 0],
		"sy": ["muzzle", 1],
		"wx": ["bullet", 0],
		"wy": ["bullet", 1],
		"tx": ["target", 0],
		"ty": ["target", 1],
		"vx": ["velocity", 0],
		"vy": ["velocity", 1],
		"cx": ["centre", 0],
		"cy": ["centre", 1],
	}
	if places.has(name_in_line):
		var key: String = places[name_in_line][0]
		var at: int = places[name_in_line][1]
		var pair: PackedFloat64Array = changed[key]
		pair[at] = value
		changed[key] = pair
	else:
		changed[{"R": "radius", "turning": "turning", "circling": "circling"}[name_in_line]] = value
	return take(changed)


func to_dictionary() -> Dictionary:
	return {
		"kind": int(kind),
		"muzzle": PackedFloat64Array([muzzle.x, muzzle.y]),
		"bullet": PackedFloat64Array([bullet.x, bullet.y]),
		"target": PackedFloat64Array([target.x, target.y]),
		"velocity": PackedFloat64Array([velocity.x, velocity.y]),
		"centre": PackedFloat64Array([centre.x, centre.y]),
		"circling": circling,
		"turning": turning,
		"radius": radius,
		"fire": own_fire,
		"mistake": mistake,
	}


func problem_in(stored: Dictionary) -> String:
	return TimedShotCheck.problem_in(stored, Kind.size(), Kind.CIRCLE)


func from_dictionary(stored: Dictionary) -> void:
	var of_muzzle: PackedFloat64Array = stored["muzzle"]
	var of_bullet: PackedFloat64Array = stored["bullet"]
	var of_target: PackedFloat64Array = stored["target"]
	var of_velocity: PackedFloat64Array = stored["velocity"]
	var of_centre: PackedFloat64Array = stored["centre"]
	kind = stored["kind"]
	muzzle.set_xy(of_muzzle[0], of_muzzle[1])
	bullet.set_xy(of_bullet[0], of_bullet[1])
	target.set_xy(of_target[0], of_target[1])
	velocity.set_xy(of_velocity[0], of_velocity[1])
	centre.set_xy(of_centre[0], of_centre[1])
	circling = stored["circling"]
	turning = stored["turning"]
	radius = stored["radius"]
	own_fire = stored["fire"]
	mistake = stored["mistake"]


func _is_faster() -> bool:
	return bullet.length() > velocity.length()


# Once for the numbers as they are.
func _solve() -> void:
	var numbers := to_dictionary().values()
	if numbers == _solved_for:
		return
	_solved_for = numbers
	_shot = solved()
	_window.clear()
	_ends.clear()
	_wrong_fire = NAN


## When to fire, as the solver finds it anew.
func solved() -> TimedShot:
	match kind:
		Kind.LINE:
			return TimedAim.at_line(muzzle, bullet, Vec2.zero(), target, velocity)
		Kind.CIRCLE:
			var turn := Vec2.deg_to_rad(circling)
			return TimedAim.at_circle(
				muzzle, bullet, Vec2.zero(), centre, circle_radius(), phase(), turn
			)
	if not _is_faster():
		return TimedShot.miss(TimedShot.Outcome.NO_CROSSING)
	return barrel().first(TimedShotCheck.LONGEST)


## The barrel that turns, as the solver knows it.
func barrel() -> TurningBarrel:
	return _barrel(bullet.length())


func _barrel(speed: float) -> TurningBarrel:
	var turn := Vec2.deg_to_rad(turning)
	var moving := AimTarget.new(target, velocity)
	return TurningBarrel.new(muzzle, bullet.angle_radians(), turn, speed, moving)


# A bullet that is fired at this moment, past a target on a circle.
func _circle_pass(at: float) -> CirclePass:
	var turn := Vec2.deg_to_rad(circling)
	return CirclePass.new(muzzle.minus(centre), bullet, circle_radius(), phase() + turn * at, turn)


# How far the window reaches to one side of the right moment, in seconds: to later for 1.
func _half_window(side: float) -> float:
	if kind == Kind.LINE:
		return half_window()
	var moment := shot().fire
	var there := target_velocity(moment + shot().flight)
	var first_guess := TimedAim.window(bullet_velocity(moment), there, radius)
	var outside := clampf(first_guess, 1e-9, 1.0)
	for doubling: int in _DOUBLINGS:
		if miss_at(moment + side * outside).distance > radius:
			break
		outside *= 2.0
	var inside := 0.0
	for halving: int in _HALVINGS:
		var middle := 0.5 * (inside + outside)
		if miss_at(moment + side * middle).distance > radius:
			outside = middle
		else:
			inside = middle
	return inside
