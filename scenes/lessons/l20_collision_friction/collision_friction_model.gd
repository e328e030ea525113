class_name CollisionFrictionModel
extends LessonModel
## A ball with spin that comes to a contact with friction: with a line, or with an equal ball at
## rest. What becomes of it is told by [FrictionContact] and [ContactFlight].
##
## The contact is at the origin of the board. Lengths in pixels, velocities in px/s, spins in
## radians per second, clockwise on screen; y points down. All masses are 1.

## How the explanation is built up.
enum Step { MEET, SLIP, PUSH, CONE, AFTER, LEDGER, FLY }

## No velocity has a component larger than this, in px/s, and no gravity is larger, in px/s².
const LARGEST := 1e4
## No spin is larger than this, in rad/s.
const FASTEST_SPIN := 1e3
## The largest friction µ.
const MOST_FRICTION := 10.0
## The smallest and the largest radius, in pixels.
const SMALLEST_RADIUS := 1.0
const LARGEST_RADIUS := 1e3
## The ball comes with at least this speed along n, in px/s.
const SLOWEST := 1.0
# The surface's direction has at least this length, and components of at most so much, in pixels.
const _SHORTEST := 1.0
const _LONGEST := 1e4
# How sentences on what is wrong call a number.
const _SYMBOLS: Dictionary[String, String] = {
	"friction": "µ", "bounciness": "C", "spin": "ω", "radius": "r", "gravity": "g"
}

## The velocity with which the ball comes to the contact, in px/s.
var velocity := Vec2.new(300.0, 400.0)
## Its spin ω there, in rad/s.
var spin := 0.0
## The direction of the surface; the ball is on its left, seen along it on the screen.
var along := Vec2.new(100.0, 0.0)
## The friction µ, 0 or more.
var friction := 0.25
## The bounciness C, 0..1.
var bounciness := 1.0
## The radius r of the ball, and of the other one, in pixels.
var radius := 20.0
## Gravity g, downwards, in px/s², where the ball meets a line.
var gravity := 0.0
## Whether it meets a ball at rest; else a line.
var two_balls := false
## Whether there is friction; else µ counts as 0.
var has_friction := true
## The mistake that is switched on, by its number in [CollisionFrictionMistakes]; 0 for none.
var mistake := 0


## The contact.
func contact() -> FrictionContact:
	var ball := Ball.new(Vec2.zero(), radius, velocity, 1.0, spin)
	var other := Ball.new(Vec2.zero(), radius) if two_balls else null
	return FrictionContact.new(ball, along, bounciness, mu(), other)


## The friction that counts.
func mu() -> float:
	return friction if has_friction else 0.0


## Gravity as a vector; none where two balls meet.
func pull() -> Vec2:
	return Vec2.new(0.0, 0.0 if two_balls else gravity)


## The flight through [param of_contact], with friction or as if there were none.
func flight(of_contact: FrictionContact, with_friction: bool) -> ContactFlight:
	return ContactFlight.new(of_contact, pull(), of_contact.friction if with_friction else 0.0)


## How far rounding alone may move the ball that is compared in [param of_flight], in pixels.
func rounding(of_contact: FrictionContact, of_flight: ContactFlight) -> float:
	if two_balls:
		return ContactRounding.of_two(of_contact, of_flight)
	return ContactRounding.off_line(of_contact, of_flight, pull())


## Whether the mistake that is switched on lets a ball leave otherwise than it does.
func shows_mistake() -> bool:
	return mistake != 0 and CollisionFrictionMistakes.is_seen(mistake, contact())


## Where the mistake changes nothing, a preset is taken in which it does.
func show_mistake(_number: int) -> void:
	for preset: String in ["Sticks", "Two balls"]:
		if mistake != 0 and not shows_mistake():
			Refusal.push(take(CollisionFrictionPresets.all()[preset]))


## Takes a typed number by its name in the formula. "" if it could be taken; else one sentence with
## the value and what is allowed, and nothing changes.
func enter(name_in_line: String, value: float) -> String:
	if name_in_line in ["vx", "vy"]:
		var wanted := velocity.copy()
		wanted.set(name_in_line[1], value)
		return take({"velocity": PackedFloat64Array([wanted.x, wanted.y])})
	return take({name_in_line: value})


func to_dictionary() -> Dictionary:
	return {
		"velocity": PackedFloat64Array([velocity.x, velocity.y]),
		"spin": spin,
		"along": PackedFloat64Array([along.x, along.y]),
		"friction": friction,
		"bounciness": bounciness,
		"radius": radius,
		"gravity": gravity,
		"two_balls": two_balls,
		"has_friction": has_friction,
		"mistake": mistake,
	}


func problem_in(stored: Dictionary) -> String:
	var problems: PackedStringArray = []
	var wanted_velocity := _vector(stored["velocity"])
	var wanted_along := _vector(stored["along"])
	for pair: Array in [["velocity", wanted_velocity, LARGEST], ["along", wanted_along, _LONGEST]]:
		var key: String = pair[0]
		var vector: Vec2 = pair[1]
		var most: float = pair[2]
		problems.append(StateCheck.within(key, vector.x, -most, most))
		problems.append(StateCheck.within(key, vector.y, -most, most))
	var limits: Dictionary[String, PackedFloat64Array] = {
		"friction": [0.0, MOST_FRICTION],
		"bounciness": [0.0, 1.0],
		"spin": [-FASTEST_SPIN, FASTEST_SPIN],
		"radius": [SMALLEST_RADIUS, LARGEST_RADIUS],
		"gravity": [0.0, LARGEST],
	}
	for key in limits:
		var number: float = stored[key]
		problems.append(StateCheck.within(_SYMBOLS[key], number, limits[key][0], limits[key][1]))
	problems.append(_problem_of_approach(wanted_velocity, wanted_along))
	var wanted_mistake: int = stored["mistake"]
	problems.append(StateCheck.mistake(wanted_mistake, CollisionFrictionMistakes.infos()))
	return StateCheck.first(problems)


func from_dictionary(stored: Dictionary) -> void:
	velocity = _vector(stored["velocity"])
	spin = stored["spin"]
	along = _vector(stored["along"])
	friction = stored["friction"]
	bounciness = stored["bounciness"]
	radius = stored["radius"]
	gravity = stored["gravity"]
	two_balls = stored["two_balls"]
	has_friction = stored["has_friction"]
	mistake = stored["mistake"]


static func _problem_of_approach(wanted_velocity: Vec2, wanted_along: Vec2) -> String:
	var length := wanted_along.length()
	if length < _SHORTEST:
		return (
			LabText.translate("The surface must be at least %s px long, not %s.")
			% [_SHORTEST, length].map(NumberText.short)
		)
	var approach := -wanted_velocity.dot(Vec2.new(wanted_along.y, -wanted_along.x)) / length
	if approach >= SLOWEST:
		return ""
	return (
		LabText.translate("The ball must come to the surface with at least %s px/s, not %s.")
		% [SLOWEST, approach].map(NumberText.short)
	)


static func _vector(stored: Variant) -> Vec2:
	var pair: PackedFloat64Array = stored
	return Vec2.new(pair[0], pair[1])
