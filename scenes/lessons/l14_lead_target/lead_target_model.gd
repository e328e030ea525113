class_name LeadTargetModel
extends LessonModel
## A shooter, a target that moves, and a bullet of constant speed that takes the shooter's own
## velocity along. Seen from the shooter the target is at P and moves with V.

## How the explanation is built up.
enum Step { NOW, RELATIVE, REACH, TIME, AIM, FIRE }
## What becomes of the shot: both touch from the start; the bullet hits; the target is faster and
## passes the reach of the bullet, so that there are two moments; it is faster and gets away; it is
## as fast and does not come nearer.
enum Case { TOUCHES, HITS, HITS_TWICE, GETS_AWAY, KEEPS_AWAY }

const _SHOOTER: PackedFloat64Array = [-120.0, -90.0]
const _TARGET: PackedFloat64Array = [120.0, -90.0]
## Presets by their titles (source text): what each changes in the model's state.
const PRESETS: Dictionary[String, Dictionary] = {
	"Across":
	{
		shooter = _SHOOTER,
		target = _TARGET,
		velocity = [0.0, 90.0],
		own = [0.0, 0.0],
		speed = 150.0,
		radius = 0.0
	},
	"Moving shooter":
	{
		shooter = _SHOOTER,
		target = _TARGET,
		velocity = [0.0, 90.0],
		own = [0.0, 90.0],
		speed = 150.0,
		radius = 0.0
	},
	"Radius":
	{
		shooter = _SHOOTER,
		target = _TARGET,
		velocity = [0.0, 90.0],
		own = [0.0, 0.0],
		speed = 135.0,
		radius = 30.0
	},
	"At rest":
	{
		shooter = _SHOOTER,
		target = _TARGET,
		velocity = [0.0, 0.0],
		own = [0.0, 0.0],
		speed = 150.0,
		radius = 0.0
	},
	"Passes by":
	{
		shooter = _SHOOTER,
		target = _TARGET,
		velocity = [-180.0, 90.0],
		own = [0.0, 0.0],
		speed = 150.0,
		radius = 0.0
	},
	"Gets away":
	{
		shooter = _SHOOTER,
		target = _TARGET,
		velocity = [180.0, 90.0],
		own = [0.0, 0.0],
		speed = 150.0,
		radius = 0.0
	},
	"Equal speeds":
	{
		shooter = _SHOOTER,
		target = _TARGET,
		velocity = [-120.0, 90.0],
		own = [0.0, 0.0],
		speed = 150.0,
		radius = 0.0
	},
	"Nearly equal":
	{
		shooter = _SHOOTER,
		target = _TARGET,
		velocity = [-90.0, 120.0],
		own = [0.0, 0.0],
		speed = 150.0000000001,
		radius = 0.0
	},
}

## No place and no velocity has a component larger than this, and no speed or radius is larger.
const LARGEST := 1e6
## No bullet is slower than this, in pixels per second.
const SLOWEST := 1e-3
## A hit that is later than this, in seconds, is not flown.
const LONGEST_FLIGHT := 1e6
# Two directions that differ by less are one.
const _SAME_DIRECTION := 1e-9

## Where the bullet leaves, in pixels.
var shooter := Vec2.new(-120.0, -90.0)
## Where the target's centre is when it does.
var target := Vec2.new(120.0, -90.0)
## The target's velocity v, in pixels per second.
var velocity := Vec2.new(0.0, 90.0)
## The shooter's own velocity u, in pixels per second.
var own := Vec2.new()
## The speed s of the bullet relative to the shooter, in pixels per second; above 0.
var speed := 150.0
## The radii of bullet and target together, in pixels; 0 where the centres must meet.
var radius := 0.0
## The mistake that is switched on, by its number in [LeadTargetMistakes]; 0 for none.
var mistake := 0
## Seconds since the shot. No part of the state: it is played, not kept.
var time := 0.0


## P: the way from the shooter to the target.
func way() -> Vec2:
	return target.minus(shooter)


## V: the velocity of the target as the shooter sees it.
func relative_velocity() -> Vec2:
	return velocity.minus(own)


## The equation for the moment of the hit.
func equation() -> LeadEquation:
	return LeadEquation.new(way(), relative_velocity(), speed, radius)


## The target, for the solvers.
func aim_target() -> AimTarget:
	return AimTarget.new(target, velocity, Vec2.zero(), radius)


## The right shot, or why there is none.
func aim() -> Aim:
	return LeadAim.first(shooter, aim_target(), speed, own)


## The same by the formula of the slide.
func aim_by_the_slide() -> Aim:
	return LeadAim.first_by_the_slide(shooter, aim_target(), speed, own)


## How late [param seconds] is for the right hit, in seconds; only where there is one.
func error_of_time(seconds: float) -> float:
	var lead := ExactLead.new(shooter, own, target, velocity, speed, radius)
	return lead.error_of(seconds, aim().time)


## Which of the cases this is.
func shot_case() -> Case:
	if equation().touches_at_once():
		return Case.TOUCHES
	var found := equation().times()
	if found.size() == 2 and found[0] < found[1]:
		return Case.HITS_TWICE
	if found:
		return Case.HITS
	return Case.GETS_AWAY if relative_velocity().length() > speed else Case.KEEPS_AWAY


## Whether some direction hits.
func can_hit() -> bool:
	return aim().hit


## Whether the hit comes in a time that can be flown.
func can_fly() -> bool:
	return can_hit() and aim().time <= LONGEST_FLIGHT


## The direction that the mistake with this number takes, of length 1; zero where it finds none.
func direction_with(number: int) -> Vec2:
	return LeadTargetMistakes.direction(number, equation(), own)


## Whether the mistake that is switched on aims in another direction than the right one, or in one
## where there is no right one.
func shows_mistake() -> bool:
	if mistake == 0:
		return false
	var wrong := direction_with(mistake)
	if not can_hit():
		return wrong.length() > 0.0
	return wrong.distance_to(aim().direction) > _SAME_DIRECTION


## Switches a mistake on. Where it changes nothing, a preset is shown in which it does.
func show_mistake(number: int) -> void:
	mistake = number
	for preset: String in ["Across", "Moving shooter"]:
		if number != 0 and not shows_mistake():
			Refusal.push(take(PRESETS[preset]))


## Where the target's centre is after [param seconds]; [param as_seen] by the shooter, or on the
## ground.
func target_after(seconds: float, as_seen: bool) -> Vec2:
	return target.plus((relative_velocity() if as_seen else velocity).scaled(seconds))


## Where the right shot meets the target as the shooter sees it; null where nothing hits, or at
## once.
func first_meeting() -> Vec2:
	return target_after(aim().time, true) if can_hit() and aim().time != 0.0 else null


## Where the shooter is after [param seconds]: where it was, for itself.
func shooter_after(seconds: float, as_seen: bool) -> Vec2:
	return shooter.copy() if as_seen else shooter.plus(own.scaled(seconds))


## Takes a typed number by its name in the formula. "" if it could be taken; else one sentence with
## the value and what is allowed, and nothing changes.
func enter(name_in_line: String, value: float) -> String:
	if name_in_line in ["speed", "radius"]:
		return take({name_in_line: value})
	var parts: Dictionary[String, Vec2] = {"S": shooter, "T": target, "v": velocity, "u": own}
	var part := parts[name_in_line[0]]
	var before := part.copy()
	part.set(name_in_line[1], value)
	var problem := problem_in(to_dictionary())
	if problem:
		part.set_xy(before.x, before.y)
	return problem


func to_dictionary() -> Dictionary:
	return {
		"shooter": PackedFloat64Array([shooter.x, shooter.y]),
		"target": PackedFloat64Array([target.x, target.y]),
		"velocity": PackedFloat64Array([velocity.x, velocity.y]),
		"own": PackedFloat64Array([own.x, own.y]),
		"speed": speed,
		"radius": radius,
		"mistake": mistake,
	}


func problem_in(stored: Dictionary) -> String:
	var problems: PackedStringArray = []
	for name_of_pair: String in ["shooter", "target", "velocity", "own"]:
		var pair: PackedFloat64Array = stored[name_of_pair]
		for number in pair:
			problems.append(StateCheck.within(name_of_pair, number, -LARGEST, LARGEST))
	var wanted_speed: float = stored["speed"]
	var wanted_radius: float = stored["radius"]
	var wanted_mistake: int = stored["mistake"]
	problems.append(StateCheck.within("s", wanted_speed, SLOWEST, LARGEST))
	problems.append(StateCheck.within("R", wanted_radius, 0.0, LARGEST))
	problems.append(StateCheck.mistake(wanted_mistake, LeadTargetMistakes.infos()))
	return StateCheck.first(problems)


func from_dictionary(stored: Dictionary) -> void:
	_put(shooter, stored["shooter"])
	_put(target, stored["target"])
	_put(velocity, stored["velocity"])
	_put(own, stored["own"])
	speed = stored["speed"]
	radius = stored["radius"]
	mistake = stored["mistake"]


static func _put(into: Vec2, stored: Variant) -> void:
	var pair: PackedFloat64Array = stored
	into.set_xy(pair[0], pair[1])
