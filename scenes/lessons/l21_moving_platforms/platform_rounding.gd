class_name PlatformRounding
extends RefCounted
## How far rounding alone may move the ball of the lesson on surfaces that move.

# The values of the state on which the place hangs, by the kind.
const _KEYS: Dictionary[MovingSurface.Kind, Array] = {
	MovingSurface.Kind.WALL: ["ball", "velocity", "surface", "surface_velocity"],
	MovingSurface.Kind.BELT: ["ball", "surface", "speed", "surface_speed", "friction"],
	MovingSurface.Kind.PLATFORM: ["surface_speed", "friction", "way"],
	MovingSurface.Kind.PADDLE: ["ball", "velocity", "surface", "turning"],
	MovingSurface.Kind.PRESS: ["way", "speed", "surface_speed"],
}


## eps times the condition of the ball's place after [param seconds], in pixels, over all numbers
## of [param model] and the moment.
static func of(model: MovingPlatformsModel, seconds: float) -> float:
	var numbers: PackedFloat64Array = []
	for key: String in _KEYS[model.kind]:
		numbers.append_array(_as_list(model.to_dictionary()[key]))
	numbers.append(seconds)
	var condition := ShotCondition.of(numbers, _place.bind(model)) + _of_bounciness(model, seconds)
	# The sizes that cannot be changed are numbers, too.
	condition += MovingSurface.RADIUS
	if model.kind == MovingSurface.Kind.PLATFORM:
		condition += MovingPlatformsModel.PLATFORM_LENGTH
	return ShotCondition.EPSILON * condition


# |C| |d place / d C|. C itself cannot be changed to both sides where it is 1.
static func _of_bounciness(model: MovingPlatformsModel, seconds: float) -> float:
	if not model.is_impact() or not model.impact().hit:
		return 0.0
	var met := model.impact()
	return model.bounciness * absf(met.seen.dot(met.normal)) * maxf(seconds - met.time, 0.0)


static func _as_list(value: Variant) -> PackedFloat64Array:
	if value is float:
		return [value]
	return value


# Where the ball is with these numbers, the last of which is the moment.
static func _place(numbers: PackedFloat64Array, model: MovingPlatformsModel) -> Vec2:
	var state := model.to_dictionary()
	var at := 0
	for key: String in _KEYS[model.kind]:
		var count := _as_list(state[key]).size()
		var part := numbers.slice(at, at + count)
		if state[key] is PackedFloat64Array:
			state[key] = part
		else:
			state[key] = part[0]
		at += count
	var changed := MovingPlatformsModel.new()
	changed.from_dictionary(state)
	return changed.place_at(numbers[-1])
