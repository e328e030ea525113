class_name RandomPlace
extends RefCounted
## Places of shooters and targets in a field of 800 x 600 px.

const _HALF_WIDTH := 400.0
const _HALF_HEIGHT := 300.0


## A place in the field, whose middle is (0, 0).
static func among(rng: RandomNumberGenerator) -> Vec2:
	return Vec2.new(
		rng.randf_range(-_HALF_WIDTH, _HALF_WIDTH), rng.randf_range(-_HALF_HEIGHT, _HALF_HEIGHT)
	)
