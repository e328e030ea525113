class_name PiStability
extends StabilityFamily
## Two blocks and a wall: if no impact is lost, their number gives the digits of pi. And balls whose
## masses differ by up to 12 powers of ten.

# The number of impacts for n = 0 to 6.
const _DIGITS: PackedInt32Array = [3, 31, 314, 3141, 31415, 314159, 3141592]
# With this number of impacts or more, the full form is long.
const _LONG := 314159

const _RATIOS: PackedFloat64Array = [1e-12, 1e-6, 7.0, 1e6, 1e12]


## See [method StabilityFamily.cases].
func cases() -> Array[StabilityCase]:
	var found: Array[StabilityCase] = []
	for n in _DIGITS.size():
		var title := tr("Digits of pi, mass ratio 100^%d") % n
		var case := _case(title, _criterion(), _try_digits.bind(n))
		if _DIGITS[n] >= _LONG:
			case.without_quick_form()
		found.append(case)
	found.append(_digits_in_the_world())
	for ratio in _RATIOS:
		var title := tr("Head-on impact of two balls, mass ratio %s") % NumberText.short(ratio)
		var criterion := tr("velocities within 8 eps, energy and momentum within 1e-15")
		found.append(_case(title, criterion, _try_masses.bind(ratio)))
	return found


func _criterion() -> String:
	return tr("the impacts spell pi, energy within 1e-12")


func _digits_in_the_world() -> StabilityCase:
	var title := tr("Digits of pi by two balls and a segment in the event world, mass ratio 100^%d")
	return _case(title % 4, _criterion(), _try_digits_in_the_world).with_quick_form(title % 2)


func _try_digits(_is_quick: bool, n: int) -> StabilityResult:
	var blocks := TwoBlocks.new()
	_need(blocks.start(100.0 ** n))
	while blocks.run(1000000):
		pass
	return _impacts_and_drift(blocks.impacts, _DIGITS[n], blocks.energy_drift())


func _try_digits_in_the_world(is_quick: bool) -> StabilityResult:
	var n := 2 if is_quick else 4
	var light := _ball(100.0, 0.0, 0.0, 0.0, 1.0)
	var heavy := _ball(200.0, 0.0, -100.0, 0.0, 1.0)
	heavy.mass = 100.0 ** n
	var world := _world([_segment(0.0, -50.0, 0.0, 50.0)], [light, heavy])
	var energy := world.energy()
	_need(world.advance(10.0))
	return _impacts_and_drift(world.impacts, _DIGITS[n], world.energy() / energy - 1.0)


func _impacts_and_drift(impacts: int, wanted: int, drift: float) -> StabilityResult:
	var figure := tr("impacts: %d, energy off by %s") % [impacts, NumberText.size(drift)]
	return StabilityResult.new(figure, impacts == wanted and absf(drift) <= 1e-12)


# A ball of mass 1 and speed 300 meets one at rest: v' = (1 - M) / (1 + M) v and 2 / (1 + M) v.
func _try_masses(_is_quick: bool, ratio: float) -> StabilityResult:
	var one := _ball(0.0, 0.0, 300.0, 0.0, 5.0)
	var other := _ball(100.0, 0.0, 0.0, 0.0, 7.0)
	other.mass = ratio
	var world := _world([], [one, other])
	_need(world.advance(1.0))
	var speed := world.velocity(0).x
	var other_speed := world.velocity(1).x
	var error := absf(speed - 300.0 * (1.0 - ratio) / (1.0 + ratio))
	error = maxf(error, absf(other_speed - 600.0 / (1.0 + ratio)))
	var in_eps := error / maxf(absf(speed), other_speed) * 2.0 ** 52
	var energy := (speed * speed + ratio * other_speed * other_speed) / 90000.0 - 1.0
	var momentum := (speed + ratio * other_speed) / 300.0 - 1.0
	var lost := maxf(absf(energy), absf(momentum))
	var figure := tr("%s eps, energy and momentum off by %s")
	figure = figure % [NumberText.size(in_eps), NumberText.size(lost)]
	return StabilityResult.new(figure, in_eps <= 8.0 and lost <= 1e-15)
