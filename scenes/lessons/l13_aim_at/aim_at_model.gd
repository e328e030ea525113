class_name AimAtModel
extends LessonModel
## A tank: a hull that has turned, a barrel that turns on it, and a target. Angles are in degrees,
## clockwise from the x axis; those of the barrel are counted from the hull.

## How the explanation is built up.
enum Step { CURRENT, SPRITE, LOOK, NESTED, TURN, EARLY, FIRE }
## What becomes of a shot at the target: hull and target are in one place, so that there is no
## direction; the target is nearer than the nozzle; the bullet gets there.
enum Case { NO_DIRECTION, TOO_NEAR, HITS }

const _HULL: PackedFloat64Array = [-80.0, -70.0]
## Presets by their titles (source text): what each changes in the model's state.
const PRESETS: Dictionary[String, Dictionary] = {
	"30°": {hull = _HULL, hull_degrees = 30.0, barrel_degrees = 0.0, target = [-80.0, 110.0]},
	"Turned":
	{hull = [80.0, 0.0], hull_degrees = 180.0, barrel_degrees = 0.0, target = [-100.0, 0.0]},
	"Over 180°":
	{hull = [80.0, 60.0], hull_degrees = 45.0, barrel_degrees = 90.0, target = [-50.0, -70.0]},
	"Behind":
	{hull = [-80.0, 0.0], hull_degrees = 0.0, barrel_degrees = 0.0, target = [-200.0, 0.0]},
	"Too near":
	{hull = [0.0, 0.0], hull_degrees = 0.0, barrel_degrees = 0.0, target = [20.0, 20.0]},
}

## No place has a component larger than this, and no speed or radius is larger.
const LARGEST := 1e6
## Where the sprite is shown the barrel fires in this gravity, in pixels per second squared.
const GRAVITY := 200.0
## When the sprite is shown there, in seconds after the shot.
const POSES: PackedFloat64Array = [0.3, 0.6, 0.9]
# The shortest barrel and the slowest bullet.
const _SMALLEST := 1e-3
# In so many half-lives a barrel is as good as aligned: a thousandth of the turn is left.
const _HALF_LIVES := 10.0
# Two directions that differ by less are one, in degrees.
const _SAME := 1e-7

## The hull's middle, where the barrel is mounted, in pixels.
var hull := Vec2.new(-80.0, -70.0)
## How far the hull is turned, in (-180, 180] degrees.
var hull_degrees := 30.0
## How far the barrel is turned on the hull, in (-180, 180] degrees.
var barrel_degrees := 0.0
## The target's centre, in pixels.
var target := Vec2.new(-80.0, 110.0)
## From the mount to the nozzle, in pixels; above 0.
var length := 50.0
## The bullet's speed, in pixels per second; above 0.
var speed := 200.0
## In this time half of the turn that is left is done, in seconds; above 0.
var half_life := 0.2
## So long after the barrel has begun to turn it fires early, in seconds.
var fire := 0.6
## The target's radius, in pixels: a shot that comes so near hits.
var radius := 10.0
## The mistake that is switched on, by its number in [AimAtMistakes]; 0 for none.
var mistake := 0
## Seconds since Play. No part of the state: it is played, not kept.
var time := 0.0


## The way from the mount to the target.
func way() -> Vec2:
	return target.minus(hull)


## What becomes of a shot at the target.
func shot_case() -> Case:
	if way().length() == 0.0:
		return Case.NO_DIRECTION
	return Case.TOO_NEAR if way().length() < length else Case.HITS


## The direction of the barrel on the ground, in (-180, 180] degrees: hull and barrel together.
func current_degrees() -> float:
	return short(hull_degrees + barrel_degrees)


## The direction in which the target is seen, in (-180, 180] degrees; 0 where there is none.
func target_degrees() -> float:
	return Vec2.rad_to_deg(Turn.toward(hull, target))


## How far the barrel must be turned on the hull to point at the target, in (-180, 180] degrees.
func wanted_degrees() -> float:
	var mount := Vec2.deg_to_rad(hull_degrees)
	return Vec2.rad_to_deg(Turn.on_mount(Turn.toward(hull, target), mount))


## By how much the barrel turns, the short way, in (-180, 180] degrees.
func turn_degrees() -> float:
	var from := Vec2.deg_to_rad(current_degrees())
	return Vec2.rad_to_deg(Turn.shortest(from, Turn.toward(hull, target)))


## How far the barrel is still off after it has eased for [param seconds], in degrees.
func left_degrees(seconds: float) -> float:
	return turn_degrees() * 0.5 ** (seconds / half_life)


## The direction of the barrel after it has eased for [param seconds], in degrees.
func degrees_after(seconds: float) -> float:
	return target_degrees() - left_degrees(seconds)


## After so many seconds of easing a shot hits the target's disc; 0 where it does at once, NAN where
## no turn would.
func least_wait() -> float:
	if shot_case() != Case.HITS:
		return NAN
	var allowed := 90.0
	if radius < way().length():
		allowed = Vec2.rad_to_deg(asin(radius / way().length()))
	var off := absf(turn_degrees())
	if off <= allowed:
		return 0.0
	return half_life * log(off / allowed) / log(2.0) if allowed > 0.0 else INF


## The nozzle of a barrel that points along [param degrees], in pixels.
func nozzle_at(degrees: float) -> Vec2:
	return hull.plus(Vec2.unit_degrees(degrees).scaled(length))


## The direction in which the mistake that is switched on leaves the barrel, in degrees; that of the
## right aim for none.
func wrong_degrees() -> float:
	return AimAtMistakes.direction(mistake, way(), hull_degrees)


## By how much the barrel turns with the mistake that is switched on, in degrees: the long way
## round, or the right way.
func wrong_turn_degrees() -> float:
	if mistake == AimAtMistakes.LONG_WAY:
		return target_degrees() - current_degrees()
	return turn_degrees()


## Whether the mistake that is switched on makes a difference.
func shows_mistake() -> bool:
	if mistake == 0 or shot_case() == Case.NO_DIRECTION:
		return false
	if mistake == AimAtMistakes.LONG_WAY:
		return absf(wrong_turn_degrees() - turn_degrees()) > _SAME
	return absf(short(wrong_degrees() - target_degrees())) > _SAME


## Switches a mistake on. Where it changes nothing, a preset is shown in which it does.
func show_mistake(number: int) -> void:
	mistake = number
	for preset: String in ["30°", "Over 180°"]:
		if number != 0 and not shows_mistake():
			Refusal.push(take(PRESETS[preset]))


## Seconds until a barrel that eases is as good as aligned.
func end_of_turn() -> float:
	return _HALF_LIVES * half_life


## [param degrees] in (-180, 180].
static func short(degrees: float) -> float:
	var turn := fposmod(degrees, 360.0)
	return turn - 360.0 if turn > 180.0 else turn


## Takes a typed number by its name in the formula. "" if it could be taken; else one sentence with
## the value and what is allowed, and nothing changes.
func enter(name_in_line: String, value: float) -> String:
	if name_in_line in ["hull_degrees", "barrel_degrees"]:
		return take({name_in_line: short(value)})
	var parts: Dictionary[String, Vec2] = {"P": hull, "T": target}
	if not parts.has(name_in_line[0]):
		return take({name_in_line: value})
	var part := parts[name_in_line[0]]
	var before := part.copy()
	part.set(name_in_line[1], value)
	var problem := problem_in(to_dictionary())
	if problem:
		part.set_xy(before.x, before.y)
	return problem


func to_dictionary() -> Dictionary:
	return {
		"hull": PackedFloat64Array([hull.x, hull.y]),
		"hull_degrees": hull_degrees,
		"barrel_degrees": barrel_degrees,
		"target": PackedFloat64Array([target.x, target.y]),
		"length": length,
		"speed": speed,
		"half_life": half_life,
		"fire": fire,
		"radius": radius,
		"mistake": mistake,
	}


func problem_in(stored: Dictionary) -> String:
	var problems: PackedStringArray = []
	for name_of_pair: String in ["hull", "target"]:
		var pair: PackedFloat64Array = stored[name_of_pair]
		for number in pair:
			problems.append(StateCheck.within(name_of_pair, number, -LARGEST, LARGEST))
	var limits: Dictionary[String, PackedFloat64Array] = {
		"hull_degrees": [-180.0, 180.0],
		"barrel_degrees": [-180.0, 180.0],
		"length": [_SMALLEST, 1e4],
		"speed": [_SMALLEST, LARGEST],
		"half_life": [0.01, 10.0],
		"fire": [0.0, 100.0],
		"radius": [0.0, LARGEST],
	}
	for key in limits:
		var value: float = stored[key]
		problems.append(StateCheck.within(key, value, limits[key][0], limits[key][1]))
	var wanted_mistake: int = stored["mistake"]
	problems.append(StateCheck.mistake(wanted_mistake, AimAtMistakes.infos()))
	return StateCheck.first(problems)


func from_dictionary(stored: Dictionary) -> void:
	_put(hull, stored["hull"])
	_put(target, stored["target"])
	hull_degrees = stored["hull_degrees"]
	barrel_degrees = stored["barrel_degrees"]
	length = stored["length"]
	speed = stored["speed"]
	half_life = stored["half_life"]
	fire = stored["fire"]
	radius = stored["radius"]
	mistake = stored["mistake"]


static func _put(into: Vec2, stored: Variant) -> void:
	var pair: PackedFloat64Array = stored
	into.set_xy(pair[0], pair[1])
