class_name LineEndsMistakes
## The mistakes of this lesson's bug gallery, each as students have written it. The right formulas
## are in `scripts/collision/`.

## Their numbers in the course's list.
const NUMBERS: Array[int] = [18, 19, 20, 22, 23]


## The impact that the mistake [param number] finds for the shot of [param model]. Its fraction
## may be any number, NaN included. Where the mistake makes no difference, it is the right impact.
static func impact(number: int, model: LineEndsModel) -> Impact:
	var right := model.impact_in(LineEndsModel.Field.ROUND_CAPS)
	var flat_hit := right.hit and right.feature == Impact.Feature.LINE
	var equation := model.cap_equation()
	match number:
		22:
			return _end_tested_at_new_position(model, right)
		23:
			return model.impact_in(LineEndsModel.Field.INFINITE_TWO_SIDED)
	if flat_hit or equation.b >= 0.0:
		return right
	match number:
		18:
			return _at(discriminant_squared(equation), model)
		20:
			return _at(from_new_position(model), model) if right.hit else right
	return right if equation.has_roots() else _at(discriminant_untested(equation), model)


## Whether the mistake changes anything for the shot of [param model].
static func shows(number: int, model: LineEndsModel) -> bool:
	var right := model.flight_in(LineEndsModel.Field.ROUND_CAPS)
	var wrong := BallFlight.new(model.start, model.motion, impact(number, model))
	if not wrong.is_finite():
		return true
	return not wrong.position_at(1.0).equals_approx(right.position_at(1.0), 1e-6)


## Whether the mistake changes something for the shot of [param model], and not the same as another
## mistake does.
static func is_seen(number: int, model: LineEndsModel) -> bool:
	var is_alike := number == 23 and _same_impact(impact(23, model), impact(22, model))
	return shows(number, model) and not is_alike


static func _same_impact(one: Impact, other: Impact) -> bool:
	return one.hit == other.hit and (not one.hit or one.fraction == other.fraction)


## Points around the ball where the mistake of [param model] has it touch: a picture must show them.
## None where that is far off.
static func outline(model: LineEndsModel) -> Array[Vec2]:
	if model.mistake == 0:
		return []
	var wrong := impact(model.mistake, model)
	if not wrong.hit or not absf(wrong.fraction) <= 2.0:
		return []
	var reach := Vec2.new(model.radius, model.radius)
	return [wrong.position.plus(reach), wrong.position.minus(reach)]


## Mistake 18: (-b - D²) / 2a: D squared instead of its root, and a = 0 not tested.
static func discriminant_squared(equation: CapEquation) -> float:
	var discriminant := equation.discriminant()
	return (-equation.b - discriminant * discriminant) / (2.0 * equation.a)


## Mistake 19: the root of a discriminant that is not tested: NaN where it is negative.
static func discriminant_untested(equation: CapEquation) -> float:
	return (-equation.b - sqrt(equation.discriminant())) / (2.0 * equation.a)


## Mistake 20: the fraction counted from the new position, at the end of the frame. NaN where there
## is no root.
static func from_new_position(model: LineEndsModel) -> float:
	var equation := CapEquation.new(
		model.new_position(), model.motion, model.radius, model.cap_point()
	)
	return equation.first_root() if equation.has_roots() else NAN


static func _at(fraction: float, model: LineEndsModel) -> Impact:
	var position := model.start.plus(model.motion.scaled(fraction))
	var normal := position.minus(model.cap_point()).normalized()
	return Impact.at(fraction, position, normal, model.nearest_cap())


# Mistake 22: tests whether the ball is beside the line after the frame, not when it touches.
static func _end_tested_at_new_position(model: LineEndsModel, right: Impact) -> Impact:
	var facing := SegmentImpact.facing_segment(model.start, model.segment)
	var flat := PointOfImpact.with_line(model.start, model.motion, model.radius, facing)
	if flat.hit and SegmentImpact.is_beside_line(model.new_position(), facing):
		return flat
	if right.hit and right.feature == Impact.Feature.LINE:
		return Impact.miss(Impact.Outcome.PASSES_BESIDE)
	return right
