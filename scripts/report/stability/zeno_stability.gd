class_name ZenoStability
extends StabilityFamily
## Bounces that pile up: a dropped ball that keeps the fraction C of its speed bounces infinitely
## often in finite time. And a ball that keeps all of its speed bounces for ever.

const _BOUNCINESSES: PackedFloat64Array = [0.0, 0.5, 0.9, 0.99, 0.999]
# The trial of a larger bounciness takes long.
const _LIVELY := 0.99
const _GRAVITY := 1000.0
const _HEIGHT := 200.0
const _RADIUS := 10.0
const _SLOPE_DEGREES := 20.0

const _BOUNCES := 1000000
const _QUICK_BOUNCES := 1500


## See [method StabilityFamily.cases].
func cases() -> Array[StabilityCase]:
	var found: Array[StabilityCase] = []
	for bounciness in _BOUNCINESSES:
		found.append(_rest_case(tr("Dropped on a floor, C = %s"), bounciness, 0.0))
	found.append(_rest_case(tr("Dropped on a slope of 20°, C = %s"), 0.9, _SLOPE_DEGREES))
	found.append(_energy_case(tr("Dropped on a floor, C = 1, %s bounces"), _try_elastic))
	found.append(_energy_case(tr("In a box without gravity, C = 1, %s bounces"), _try_box))
	return found


func _energy_case(title: String, trial: Callable) -> StabilityCase:
	var case := _case(title % "10^6", tr("energy within 1e-12"), trial)
	return case.with_quick_form(title % _QUICK_BOUNCES)


func _rest_case(title: String, bounciness: float, slope: float) -> StabilityCase:
	var criterion := tr("rest after %s s within 1e-9 s")
	var case := _case(
		title % NumberText.short(bounciness),
		criterion % NumberText.short(_rest_time(bounciness, slope), 6),
		_try_rest.bind(bounciness, slope)
	)
	if bounciness > _LIVELY:
		case.without_quick_form()
	return case


# One fall, then infinitely many hops: t (1 + 2 C + 2 C^2 + ...) = t (1 + C) / (1 - C).
func _rest_time(bounciness: float, slope_degrees: float) -> float:
	var pull := _GRAVITY * cos(Vec2.deg_to_rad(slope_degrees))
	return sqrt(2.0 * _HEIGHT / pull) * (1.0 + bounciness) / (1.0 - bounciness)


func _try_rest(_is_quick: bool, bounciness: float, slope_degrees: float) -> StabilityResult:
	var along := Vec2.unit_degrees(slope_degrees)
	var start := along.normal().scaled(-_HEIGHT - _RADIUS)
	var floor_line := LineSegment.new(along.scaled(-1e3), along.scaled(1e9))
	var world := _world([floor_line], [Ball.new(start, _RADIUS)])
	_need(world.set_gravity(Vec2.new(0.0, _GRAVITY)))
	_need(world.set_bounciness(bounciness))
	var wanted := _rest_time(bounciness, slope_degrees)
	_need(world.advance(wanted + 1.0))
	# The last flight, in which the ball lies or slides, begins when it comes to rest.
	var error := absf(world.flight_start(0) - wanted)
	var figure := tr("bounces: %d, rest off by %s s") % [world.impacts, NumberText.size(error)]
	return StabilityResult.new(figure, error <= 1e-9 and world.is_resting(0))


func _try_elastic(is_quick: bool) -> StabilityResult:
	var ball := Ball.new(Vec2.new(0.0, -_HEIGHT - _RADIUS), _RADIUS)
	var world := _world([_segment(-100.0, 0.0, 100.0, 0.0)], [ball])
	_need(world.set_gravity(Vec2.new(0.0, _GRAVITY)))
	return _energy_after_bounces(world, is_quick)


func _try_box(is_quick: bool) -> StabilityResult:
	var box := _rectangle(Vec2.new(0.0, 0.0), Vec2.new(600.0, 400.0))
	return _energy_after_bounces(_world(box, [_ball(137.0, 91.0, 431.0, 277.0, _RADIUS)]), is_quick)


func _energy_after_bounces(world: EventWorld, is_quick: bool) -> StabilityResult:
	var wanted := _QUICK_BOUNCES if is_quick else _BOUNCES
	var energy := world.energy()
	var worst := 0.0
	while world.impacts < wanted and refusal == "":
		_need(world.advance(100.0 if is_quick else 10000.0))
		worst = maxf(worst, absf(world.energy() / energy - 1.0))
	return _at_most(worst, 1e-12)
