class_name ProjectionPairs
extends RefCounted
## The vectors of the first problem: easy ones and hard ones.

## Any directions, lengths from 1 to 100 px.
const EASY := "up to 100 px"
## Within 1e-9 rad of a right angle.
const PERPENDICULAR := "nearly perpendicular"
## Any lengths that 32-bit numbers can just hold.
const LONG_AND_SHORT := "1e-30 to 1e30 px"
## All of them.
const SITUATIONS: PackedStringArray = [EASY, PERPENDICULAR, LONG_AND_SHORT]

## The number of pairs in each situation.
const COUNT := 200


## Pairs a, b one after the other, the same at every call.
static func of(situation: String) -> Array[Vec2]:
	var rng := RandomNumberGenerator.new()
	rng.seed = 1
	var found: Array[Vec2] = []
	for pair in COUNT:
		var a := _vector(rng)
		var b := _vector(rng)
		if situation == PERPENDICULAR:
			b = a.normal().scaled(b.length()).plus(a.scaled(rng.randf() * 1e-9))
		elif situation == LONG_AND_SHORT:
			a.scale(10.0 ** rng.randf_range(-30.0, 28.0))
			b.scale(10.0 ** rng.randf_range(-30.0, 28.0))
		found.append_array([a, b])
	return found


# Never zero, and with all 53 bits, because a cosine has them.
static func _vector(rng: RandomNumberGenerator) -> Vec2:
	return Vec2.unit_radians(rng.randf() * TAU).scaled(rng.randf_range(1.0, 100.0))
