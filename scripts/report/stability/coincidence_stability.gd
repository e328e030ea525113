class_name CoincidenceStability
extends StabilityFamily
## Events at the same time, and things at the same place. All numbers are whole, so that nothing is
## rounded and the answers are exact.


## See [method StabilityFamily.cases].
func cases() -> Array[StabilityCase]:
	var back := tr("comes back the same way to the last bit")
	return [
		_case(tr("Into a corner of two segments"), back, _try_corner_of_segments),
		_case(
			tr("Into a corner of the walls: two at the same instant"), back, _try_corner_of_walls
		),
		_case(tr("Straight onto the end of a segment"), back, _try_end),
		_case(tr("Straight onto the point where two segments meet"), back, _try_tip),
		_case(
			tr("Nine identical segments on top of each other"),
			tr("the bits of one segment"),
			_try_identical
		),
		_case(
			tr("Three balls at once: the middle one hit from both sides"),
			tr("the outer ones swap their velocities to the last bit"),
			_try_from_both_sides
		),
		_case(
			tr("Three balls at once: one into two that touch"),
			tr("energy and momentum within 1e-14; apart afterwards"),
			_try_break
		),
		_case(
			tr("A row of five balls that touch, hit by one"),
			tr("the last one leaves with all of the speed"),
			_try_cradle
		),
	]


func _try_corner_of_segments(_is_quick: bool) -> StabilityResult:
	var sides: Array[LineSegment] = [
		_segment(200.0, -300.0, 200.0, 200.0), _segment(200.0, 200.0, -300.0, 200.0)
	]
	return _way_back(_world(sides, [_ball(90.0, 90.0, 50.0, 50.0, 10.0)]), 4.0)


func _try_corner_of_walls(_is_quick: bool) -> StabilityResult:
	var world := _world([], [_ball(90.0, 90.0, 50.0, 50.0, 10.0)])
	_need(world.set_walls(Vec2.new(-300.0, -300.0), Vec2.new(200.0, 200.0)))
	return _way_back(world, 4.0)


func _try_end(_is_quick: bool) -> StabilityResult:
	var world := _world([_segment(200.0, 0.0, 400.0, 0.0)], [_ball(90.0, 0.0, 50.0, 0.0, 10.0)])
	return _way_back(world, 4.0)


func _try_tip(_is_quick: bool) -> StabilityResult:
	var sides: Array[LineSegment] = [
		_segment(300.0, -100.0, 200.0, 0.0), _segment(200.0, 0.0, 300.0, 100.0)
	]
	return _way_back(_world(sides, [_ball(90.0, 0.0, 50.0, 0.0, 10.0)]), 4.0)


# The balls after the time to the impact and back.
func _way_back(world: EventWorld, seconds: float) -> StabilityResult:
	var start := world.position(0)
	var velocity := world.velocity(0)
	_need(world.advance(seconds))
	var off := world.position(0).distance_to(start)
	var turned := world.velocity(0).plus(velocity).length()
	var figure := tr("%s px and %s px/s off") % [NumberText.size(off), NumberText.size(turned)]
	return StabilityResult.new(figure, off == 0.0 and turned == 0.0)


func _try_identical(_is_quick: bool) -> StabilityResult:
	var one: Array[LineSegment] = [_segment(-100.0, 70.0, 130.0, 33.0)]
	var many: Array[LineSegment] = []
	for copy in 9:
		many.append(one[0])
	var single := _world(one, [_ball(0.0, 0.0, 31.0, 57.0, 10.0)])
	var stacked := _world(many, [_ball(0.0, 0.0, 31.0, 57.0, 10.0)])
	_need(single.advance(3.0))
	_need(stacked.advance(3.0))
	var apart := single.position(0).distance_to(stacked.position(0))
	var figure := tr("bounces: %d, %s px apart") % [stacked.impacts, NumberText.size(apart)]
	return StabilityResult.new(figure, stacked.impacts == 1 and apart == 0.0)


func _try_from_both_sides(_is_quick: bool) -> StabilityResult:
	var balls: Array[Ball] = [
		_ball(-100.0, 0.0, 40.0, 0.0, 10.0),
		_ball(0.0, 0.0, 0.0, 0.0, 10.0),
		_ball(100.0, 0.0, -40.0, 0.0, 10.0),
	]
	var world := _world([], balls)
	_need(world.advance(4.0))
	return _row(world, [-40.0, 0.0, 40.0])


func _try_cradle(_is_quick: bool) -> StabilityResult:
	var balls: Array[Ball] = [_ball(-100.0, 0.0, 40.0, 0.0, 10.0)]
	for place in 5:
		balls.append(_ball(20.0 * place, 0.0, 0.0, 0.0, 10.0))
	var world := _world([], balls)
	_need(world.advance(4.0))
	return _row(world, [0.0, 0.0, 0.0, 0.0, 0.0, 40.0])


# Passed if the balls of the row have exactly these velocities.
func _row(world: EventWorld, wanted: PackedFloat64Array) -> StabilityResult:
	var off := 0.0
	for index in wanted.size():
		off = maxf(off, world.velocity(index).distance_to(Vec2.new(wanted[index], 0.0)))
	var figure := tr("impacts: %d, %s px/s off") % [world.impacts, NumberText.size(off)]
	return StabilityResult.new(figure, off == 0.0)


# Both balls touch the first one at the same time. Which impact comes first is a matter of choice,
# but neither order may lose anything.
func _try_break(_is_quick: bool) -> StabilityResult:
	var balls: Array[Ball] = [
		_ball(-100.0, 0.0, 40.0, 0.0, 10.0),
		_ball(0.0, -10.0, 0.0, 0.0, 10.0),
		_ball(0.0, 10.0, 0.0, 0.0, 10.0),
	]
	var world := _world([], balls)
	_need(world.advance(4.0))
	var momentum := Vec2.new(-40.0, 0.0)
	var energy := -40.0 * 40.0
	for index in 3:
		momentum.add(world.velocity(index))
		energy += world.velocity(index).length_squared()
	var lost := maxf(momentum.length() / 40.0, absf(energy) / 1600.0)
	var least := world.position(1).distance_to(world.position(2))
	for index: int in [1, 2]:
		least = minf(least, world.position(0).distance_to(world.position(index)))
	var figure := tr("impacts: %d, %s lost, centres at least %s px apart")
	figure = figure % [world.impacts, NumberText.size(lost), NumberText.short(least, 12)]
	return StabilityResult.new(figure, lost <= 1e-14 and least >= 20.0)
