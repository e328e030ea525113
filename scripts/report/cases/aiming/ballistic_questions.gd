class_name BallisticQuestions
extends RefCounted
## What is asked of the ways to aim under gravity.

## The target rests, and the bullet is fast enough.
const REST := "target at rest"
## The bullet has hardly the speed that it needs.
const EDGE := "edge of reach"
## The target is straight above the shooter.
const ABOVE := "straight above"
## The target moves.
const MOVING := "moving target"
## All of them.
const SITUATIONS: PackedStringArray = [REST, EDGE, ABOVE, MOVING]

const _COUNT := 40
const _QUICK_COUNT := 10
const _SEED := 22
# px/s².
const _GRAVITY := 300.0
# Seconds.
const _LONGEST := 10.0


## Questions with an answer, the same at every call; the quick form has the first of them.
static func of(situation: String, is_quick: bool) -> Array[AimQuestion]:
	var rng := RandomNumberGenerator.new()
	rng.seed = _SEED
	var found: Array[AimQuestion] = []
	while found.size() < (_QUICK_COUNT if is_quick else _COUNT):
		var question := _question(situation, rng)
		if question.time > 0.0:
			found.append(question)
	return found


static func _question(situation: String, rng: RandomNumberGenerator) -> AimQuestion:
	var gravity := Vec2.new(0.0, _GRAVITY)
	var shooter := RandomPlace.among(rng)
	var place := RandomPlace.among(rng)
	if situation == ABOVE:
		place = shooter.plus(Vec2.new(0.0, -rng.randf_range(50.0, 400.0)))
	var factor := rng.randf_range(1.05, 1.6)
	if situation == EDGE:
		factor = 1.0 + rng.randf_range(1e-13, 1e-11)
	var velocity := Vec2.zero()
	if situation == MOVING:
		velocity = Vec2.random_unit(rng).scaled(rng.randf_range(20.0, 120.0))
	var speed := factor * BallisticAim.least_speed(shooter, place, gravity)
	return AimQuestion.new(shooter, AimTarget.new(place, velocity), speed, gravity, _LONGEST)
