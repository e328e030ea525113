class_name LeadQuestions
extends RefCounted
## What is asked of the ways to aim ahead of a moving target.

## The bullet is at least twice as fast as the target.
const SLOW := "slower target"
## Within one part in 1e9 of the bullet's speed.
const EQUAL := "nearly equal speeds"
## The target is faster and comes near.
const FAST := "faster target"
## All of them.
const SITUATIONS: PackedStringArray = [SLOW, EQUAL, FAST]

const _COUNT := 40
const _QUICK_COUNT := 10
const _SEED := 21
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
	var shooter := RandomPlace.among(rng)
	var place := RandomPlace.among(rng)
	var speed := rng.randf_range(200.0, 500.0)
	var direction := Vec2.random_unit(rng)
	var target_speed := rng.randf_range(0.1, 0.5) * speed
	if situation == EQUAL:
		target_speed = speed * (1.0 + rng.randf_range(-1e-9, 1e-9))
	elif situation == FAST:
		target_speed = speed * rng.randf_range(1.2, 2.0)
		direction = shooter.minus(place).normalized()
		direction.rotate_radians(rng.randf_range(-0.4, 0.4))
	var target := AimTarget.new(place, direction.scaled(target_speed))
	return AimQuestion.new(shooter, target, speed, Vec2.zero(), _LONGEST)
