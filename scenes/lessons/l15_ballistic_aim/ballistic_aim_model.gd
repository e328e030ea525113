class_name BallisticAimModel
extends LessonModel
## A shot from the origin at a target, under gravity: all aims that hit, the least speed, and what a
## mistake makes of it.
##
## Pixels, seconds, y points down. The shot is fired at time 0; the target moves from then on.

## How the drawing is built up. From [code]ARCS[/code] on, the shot that is flown is one that hits.
enum Step { STRAIGHT, DROP, TIMES, ARCS, LEAST, FIRE }

## Why no aim hits: both are in one place; the speed is less than the least; the target is faster
## and gets away; no aim hits within
## [constant BallisticShots.LONGEST].
enum Reason { SAME_PLACE, TOO_SLOW, OUTRUN, NOT_IN_TIME }

## Presets by their titles (source text): what each changes in the model's state.
const PRESETS: Dictionary[String, Dictionary] = {
	"Two arcs": {target = [200, 0], speed = 250.0, gravity = 300.0, moves = false, falls = false},
	"Edge": {target = [80, -60], speed = 200.0, gravity = 250.0, moves = false, falls = false},
	"Out of reach":
	{target = [200, 0], speed = 240.0, gravity = 300.0, moves = false, falls = false},
	"Straight up":
	{target = [0, -80], speed = 250.0, gravity = 300.0, moves = false, falls = false},
	"Faster": {target = [200, 0], speed = 500.0, gravity = 300.0, moves = false, falls = false},
	"g = 0": {target = [200, -50], speed = 250.0, gravity = 0.0, moves = false, falls = false},
	"Falling target":
	{target = [160, -120], speed = 400.0, gravity = 300.0, moves = false, falls = true},
	"Moving target":
	{
		target = [200, 0],
		velocity = [-60, 0],
		speed = 250.0,
		gravity = 300.0,
		moves = true,
		falls = false
	},
	"Four aims":
	{
		target = [0, -120],
		velocity = [-240, 300],
		speed = 250.0,
		gravity = 200.0,
		moves = true,
		falls = false
	},
}

## No place, speed or gravity is larger than this, in pixels and seconds.
const LARGEST := 1e5
## The bullet is not slower than this, in px/s.
const SLOWEST := 1.0
## As many aims hit at most.
const MOST_AIMS := 4
## The arrows of velocities and of gravity show so many seconds of them.
const ARROW_SECONDS := 0.5

# A shot that does not hit is flown so long, as a share of the time of the straight way.
const _STRAIGHT_SHARE := 1.4

## The target's centre when the shot is fired.
var target := Vec2.new(200.0, 0.0)
## Its velocity, in px/s, where it [member moves].
var velocity := Vec2.new(-60.0, 0.0)
## The bullet's speed, in px/s.
var speed := 250.0
## Gravity, in px/s², straight down; 0 for none.
var gravity := 300.0
## The target moves with its velocity.
var moves := false
## The target starts to fall as the shot is fired.
var falls := false
## Which of the aims that hit is flown, from 0: of two, the flat arc first.
var arc := 0
## The number of the mistake that is switched on; 0 for none.
var mistake := 0
## Seconds since the shot.
var time := 0.0

# What the solver found, and for which numbers.
var _shots: Array[Aim] = []
var _wrong: WrongShot
var _solved_for: Array = []


## Gravity as a vector.
func pull() -> Vec2:
	return Vec2.new(0.0, gravity)


## The target as the solver knows it.
func aim_target() -> AimTarget:
	return AimTarget.new(target, own_velocity(), pull() if falls else Vec2.zero())


## The target's velocity, in px/s: zero where it does not move.
func own_velocity() -> Vec2:
	return velocity.copy() if moves else Vec2.zero()


## The acceleration of the target as the bullet sees it, in px/s².
func bend() -> Vec2:
	return Vec2.zero() if falls else pull().negated()


## Whether the target stays where it is: then there are a least speed and two arcs.
func is_fixed() -> bool:
	return own_velocity().length() == 0.0 and (not falls or gravity == 0.0)


## Whether the target is straight above or below: then the aim is straight, too.
func is_upright() -> bool:
	return is_fixed() and target.x == 0.0 and target.y != 0.0


## All aims that hit, the earliest first: up to two at a target that rests, else up to four.
func shots() -> Array[Aim]:
	_solve()
	return _shots


## Whether any aim hits.
func has_shot() -> bool:
	return not shots().is_empty()


## Where the first aim that hits points; null where none hits.
func first_aim_point() -> Vec2:
	return aim_point(shots()[0]) if has_shot() else null


## The place in [method shots] of the aim that is flown.
func arc_flown() -> int:
	return clampi(arc, 0, maxi(shots().size() - 1, 0))


## The aim that is flown. Only where there is one.
func shot() -> Aim:
	return shots()[arc_flown()]


## Why no aim hits; only where none does.
func reason() -> Reason:
	if target.length() == 0.0:
		return Reason.SAME_PLACE
	if is_fixed():
		return Reason.TOO_SLOW
	var has_straight_way := bend().length() == 0.0
	if has_straight_way and not LeadAim.first(Vec2.zero(), aim_target(), speed).hit:
		return Reason.OUTRUN
	return Reason.NOT_IN_TIME


## The speed that reaches a target at rest at least, in px/s.
func least_speed() -> float:
	return BallisticAim.least_speed(Vec2.zero(), target, pull())


## The direction of the shot at the [method least_speed], of length 1: it halves the angle between
## the way to the target and straight up. Zero where both are opposite.
func least_direction() -> Vec2:
	return target.normalized().plus(Vec2.new(0.0, -1.0)).normalized()


## Whether [method least_direction] and [method least_speed] say something: the target rests, there
## is gravity, and a bullet that is only dropped does not do.
func has_least() -> bool:
	return is_fixed() and gravity > 0.0 and least_speed() > 0.0


## b = s² + g P.y, in px²/s².
func b() -> float:
	return speed * speed + gravity * target.y


## w = b² - (g |P|)² of a target at rest. Below 0 no aim hits.
func w() -> float:
	var pulled := gravity * target.length()
	var found := (b() - pulled) * (b() + pulled)
	return maxf(found, 0.0) if has_shot() else minf(found, 0.0)


## The time of the straight way to the target, in seconds.
func straight_time() -> float:
	return target.length() / speed


## How far the bullet falls in so many seconds, in pixels.
func fall_after(seconds: float) -> float:
	return 0.5 * gravity * seconds * seconds


## Where [param of_shot] aims: the target, less the fall of the bullet.
func aim_point(of_shot: Aim) -> Vec2:
	return of_shot.target.minus(Vec2.new(0.0, fall_after(of_shot.time)))


## Where the target is after so many seconds.
func target_after(seconds: float) -> Vec2:
	return aim_target().position_after(seconds)


## The direction in which the bullet is shot at [param step], of length 1: straight at the target up
## to the step that shows the arcs. Zero where nothing is shot.
func direction(step: Step) -> Vec2:
	if step < Step.ARCS:
		return target.normalized()
	return shot().direction.copy() if has_shot() else Vec2.zero()


## Where a bullet that is shot in [param towards], of length 1, is after so many seconds.
func bullet_after(seconds: float, towards: Vec2) -> Vec2:
	return towards.scaled(speed * seconds).plus(Vec2.new(0.0, fall_after(seconds)))


## The velocity with which it is shot.
func bullet_velocity(towards: Vec2) -> Vec2:
	return towards.scaled(speed)


## How long the shots of [param step] are flown, in seconds.
func end(step: Step) -> float:
	if step < Step.ARCS:
		return _STRAIGHT_SHARE * straight_time()
	var last := shot().time if has_shot() else 0.0
	return maxf(last, wrong_end()) if compares(step) else last


## By how much the aim that is flown misses, as the event world flies it. Only where there is one.
func miss() -> ShotMiss:
	return miss_of(shot().direction, shot().time)


## The same for a shot in [param towards], of length 1, which was computed to hit after
## [param computed] seconds. A target that moves is watched for
## [constant BallisticShots.LONGEST], one that rests until then, too.
##
## What falls as the bullet does is seen from a place that falls with both. Else the rounding of the
## common fall, which may be a thousand times as far as the target, would be taken for a miss.
func miss_of(towards: Vec2, computed: float) -> ShotMiss:
	var leaving := bullet_velocity(towards)
	var seen := AimTarget.new(target, own_velocity())
	var last := BallisticShots.LONGEST
	var counted := computed if is_fixed() else minf(computed, last)
	return ShotMiss.of(Vec2.zero(), leaving, bend().negated(), seen, last, counted)


## eps times the condition of the aim that is flown, in pixels: so far rounding alone may move it.
## Only where there is one.
func rounding() -> float:
	var d := shot().direction
	var v := own_velocity()
	var fall := 0.0 if falls else 1.0
	var numbers: PackedFloat64Array = [
		target.x, target.y, v.x, v.y, speed, gravity, d.x, d.y, shot().time
	]
	var off := func(n: PackedFloat64Array) -> Vec2:
		var t := n[8]
		return Vec2.new(
			n[0] + (n[2] - n[4] * n[6]) * t,
			n[1] + (n[3] - n[4] * n[7]) * t - fall * 0.5 * n[5] * t * t
		)
	return ShotCondition.EPSILON * ShotCondition.of(numbers, off)


## By how much the time of the aim that is flown is off, in seconds. Only where there is one.
func error_of_time(seconds: float) -> float:
	return ExactAim.error_of_time(seconds, target, own_velocity(), bend(), speed)


## The shot to which the mistake that is switched on leads.
func wrong_shot() -> WrongShot:
	_solve()
	return _wrong


## Whether [param step] is about a single aim, beside which that of a mistake is shown.
static func is_of_arcs(step: Step) -> bool:
	return step == Step.ARCS or step == Step.FIRE


## The step at which a mistake is shown beside a single aim, for who switches it on at [param step].
static func step_of_mistake(_mistake: int, step: int) -> int:
	return step if is_of_arcs(step as Step) else Step.ARCS


## Whether the shot of the mistake is shown beside the right one at [param step].
func compares(step: Step) -> bool:
	return is_of_arcs(step) and mistake_shows()


## Whether the mistake that is switched on leads to anything else than the right aim.
func mistake_shows() -> bool:
	if mistake == 0 or target.length() == 0.0:
		return false
	if not wrong_shot().hit:
		return has_shot() or mistake == BallisticAimMistakes.NOT_TESTED
	var off := INF
	if has_shot():
		off = wrong_shot().direction.distance_to(shot().direction)
	return off > 1e-9


## Whether the forgotten half makes half of the right time of flight: for a target on the level.
func says_half() -> bool:
	var is_level := is_fixed() and target.y == 0.0 and gravity > 0.0
	return mistake == BallisticAimMistakes.HALF and is_level and has_shot()


## Until when the bullet of the mistake is flown: until it is nearest to the target.
func wrong_end() -> float:
	return wrong_shot().miss.moment if wrong_shot().hit else 0.0


## Takes a typed number by its name in the formula lines. "" if it could be taken; else one sentence
## with the value and what is allowed.
func enter(name_in_line: String, value: float) -> String:
	var problem := _problem_of(name_in_line, value)
	if problem:
		return problem
	match name_in_line:
		"x":
			target.x = value
		"y":
			target.y = value
		"vx":
			velocity.x = value
		"vy":
			velocity.y = value
		"s":
			speed = value
		"g":
			gravity = value
	return ""


static func _problem_of(name_in_line: String, value: float) -> String:
	match name_in_line:
		"s":
			return StateCheck.within("s", value, SLOWEST, LARGEST)
		"g":
			return StateCheck.within("g", value, 0.0, LARGEST)
	return StateCheck.within(name_in_line, value, -LARGEST, LARGEST)


func to_dictionary() -> Dictionary:
	return {
		"target": PackedFloat64Array([target.x, target.y]),
		"velocity": PackedFloat64Array([velocity.x, velocity.y]),
		"speed": speed,
		"gravity": gravity,
		"moves": moves,
		"falls": falls,
		"arc": arc,
		"mistake": mistake,
	}


func problem_in(stored: Dictionary) -> String:
	var model := BallisticAimModel.new()
	model.from_dictionary(stored)
	return (
		StateCheck
		. first(
			[
				model.enter("x", model.target.x),
				model.enter("y", model.target.y),
				model.enter("vx", model.velocity.x),
				model.enter("vy", model.velocity.y),
				model.enter("s", model.speed),
				model.enter("g", model.gravity),
				StateCheck.within("arc", model.arc, 0, MOST_AIMS - 1),
				StateCheck.mistake(model.mistake, BallisticAimMistakes.infos()),
			]
		)
	)


func from_dictionary(stored: Dictionary) -> void:
	var of_target: PackedFloat64Array = stored["target"]
	var of_velocity: PackedFloat64Array = stored["velocity"]
	target.set_xy(of_target[0], of_target[1])
	velocity.set_xy(of_velocity[0], of_velocity[1])
	speed = stored["speed"]
	gravity = stored["gravity"]
	moves = stored["moves"]
	falls = stored["falls"]
	arc = stored["arc"]
	mistake = stored["mistake"]


# Once for the numbers as they are.
func _solve() -> void:
	var numbers := to_dictionary().values()
	if numbers == _solved_for:
		return
	_solved_for = numbers
	_shots = BallisticShots.aims(aim_target(), pull(), speed)
	_wrong = _shot_of_mistake()


# Of several, the one in the place of the arc that is flown.
func _shot_of_mistake() -> WrongShot:
	var found := WrongShot.new()
	var aims := BallisticAimMistakes.aims(mistake, aim_target(), pull(), speed)
	if aims.is_empty():
		return found
	var aim := aims[clampi(arc, 0, aims.size() - 1)]
	found.hit = true
	found.direction = aim.direction
	found.miss = miss_of(aim.direction, aim.time)
	return found
