class_name OverlapStability
extends StabilityFamily
## Invalid starts: a ball that overlaps something already.

# Endless bounces are recognized by this limit as well as by the world's own of a million.
const _MOST_IMPACTS := 2000


## See [method StabilityFamily.cases].
func cases() -> Array[StabilityCase]:
	return [
		_case(
			tr("Starts in overlap with a segment, flying away"),
			tr("no impact, straight on to the last bit"),
			_try_segment.bind(-1.0)
		),
		_case(
			tr("Starts in overlap with a segment, flying into it"),
			tr("one impact at once, back to the last bit"),
			_try_segment.bind(1.0)
		),
		_case(
			tr("Starts with its centre on a segment"),
			tr("one impact at once, out on the side it came from"),
			_try_centre
		),
		_case(
			tr("Two balls start in overlap, flying apart"),
			tr("no impact, straight on to the last bit"),
			_try_balls.bind(-1.0)
		),
		_case(
			tr("Two balls start in overlap, flying together"),
			tr("one impact at once, velocities swapped to the last bit"),
			_try_balls.bind(1.0)
		),
		_case(
			tr("Two balls start at the very same place"),
			tr("finite places and velocities, energy within 1e-12"),
			_try_same_place
		),
		_case(
			tr("Starts caught between two segments closer than 2 r"),
			tr("no hang: goes on, or says why not"),
			_try_caught
		),
	]


# The ball overlaps the line by 5 of its 10 px, from above. `down` is its speed into the line.
func _try_segment(_is_quick: bool, down: float) -> StabilityResult:
	var world := _world(
		[_segment(-90.0, 0.0, 90.0, 0.0)], [_ball(3.0, -5.0, 7.0, down * 8.0, 10.0)]
	)
	_need(world.advance(2.0))
	var off := world.position(0).distance_to(Vec2.new(17.0, -21.0))
	var figure := tr("impacts: %d, %s px off") % [world.impacts, NumberText.size(off)]
	return StabilityResult.new(figure, world.impacts == (1 if down > 0.0 else 0) and off == 0.0)


func _try_centre(_is_quick: bool) -> StabilityResult:
	var world := _world([_segment(-90.0, 0.0, 90.0, 0.0)], [_ball(3.0, 0.0, 7.0, 8.0, 10.0)])
	world.most_impacts_per_second = _MOST_IMPACTS
	_need(world.advance(2.0))
	var off := world.position(0).distance_to(Vec2.new(17.0, -16.0))
	var figure := tr("impacts: %d, %s px off") % [world.impacts, NumberText.size(off)]
	return StabilityResult.new(figure, world.impacts == 1 and off == 0.0)


# Two balls side by side overlap by 5 of 20 px. Each has 8 px/s, and then the other's velocity.
func _try_balls(_is_quick: bool, inwards: float) -> StabilityResult:
	var left := _ball(0.0, 0.0, inwards * 8.0, 4.0, 10.0)
	var right := _ball(15.0, 0.0, -inwards * 8.0, 4.0, 10.0)
	var world := _world([], [left, right])
	_need(world.advance(2.0))
	var off := world.position(0).distance_to(Vec2.new(-16.0, 8.0))
	off = maxf(off, world.position(1).distance_to(Vec2.new(31.0, 8.0)))
	var figure := tr("impacts: %d, %s px off") % [world.impacts, NumberText.size(off)]
	return StabilityResult.new(figure, world.impacts == (1 if inwards > 0.0 else 0) and off == 0.0)


func _try_same_place(_is_quick: bool) -> StabilityResult:
	var world := _world([], [_ball(0.0, 0.0, 8.0, 4.0, 10.0), _ball(0.0, 0.0, -8.0, 4.0, 10.0)])
	var energy := world.energy()
	_need(world.advance(2.0))
	var lost := absf(world.energy() / energy - 1.0)
	var is_right := world.position(0).is_finite() and world.position(1).is_finite()
	var figure := tr("impacts: %d, energy off by %s") % [world.impacts, NumberText.size(lost)]
	return StabilityResult.new(figure, is_right and lost <= 1e-12)


# No motion is right here. What matters is that the call ends, and that the world says so.
func _try_caught(_is_quick: bool) -> StabilityResult:
	var sides: Array[LineSegment] = [
		_segment(-90.0, -6.0, 90.0, -6.0), _segment(-90.0, 6.0, 90.0, 6.0)
	]
	var world := _world(sides, [_ball(0.0, 1.0, 3.0, 50.0, 10.0)])
	world.most_impacts_per_second = _MOST_IMPACTS
	var sentence := world.advance(1.0)
	var is_inside := absf(world.position_y(0)) <= 6.0
	var figure := sentence if sentence else tr("impacts: %d, y = %s px")
	if sentence == "":
		figure = figure % [world.impacts, NumberText.short(world.position_y(0))]
	return StabilityResult.new(figure, is_inside)
