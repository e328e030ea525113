class_name CollisionFrictionPresets
extends RefCounted
## The presets of the lesson on friction at a bounce.

const _LEVEL: PackedFloat64Array = [100.0, 0.0]
const _DOWN: PackedFloat64Array = [300.0, 400.0]


## What each preset changes in the model's state, by its title (source text).
static func all() -> Dictionary[String, Dictionary]:
	return {
		"Sticks": _preset(_DOWN, {}),
		"Slips": _preset(_DOWN, {friction = 0.1}),
		"Backspin": _preset(_DOWN, {friction = 0.5, spin = -30.0}),
		"C = 0.5": _preset(_DOWN, {bounciness = 0.5}),
		"Slope": _preset([0.0, 500.0], {along = PackedFloat64Array([80.0, 60.0])}),
		"Hops": _preset([180.0, 300.0], {friction = 0.1, bounciness = 0.8, gravity = 900.0}),
		"Two balls":
		_preset(
			[250.0, 0.0],
			{friction = 0.2, two_balls = true, along = PackedFloat64Array([45.0, -60.0])}
		),
	}


# A ball that does not turn comes to a level line, unless it is told otherwise.
static func _preset(velocity: PackedFloat64Array, others: Dictionary) -> Dictionary:
	var level := {
		velocity = velocity,
		spin = 0.0,
		along = _LEVEL,
		friction = 0.25,
		bounciness = 1.0,
		radius = 20.0,
		gravity = 0.0,
		two_balls = false,
		has_friction = true,
	}
	return level.merged(others, true)
