class_name ScaleStability
extends StabilityFamily
## The same flight in a box at very different speeds, sizes, places and time steps. Unfolding gives
## the exact end: between two walls each coordinate is that of a straight flight, folded back.

const _SPEEDS: PackedFloat64Array = [1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9]
const _RADII: PackedFloat64Array = [1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6]
const _STEPS: PackedFloat64Array = [1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6]
const _STEPS_MADE := 500
# The length of the paths, about, in pixels.
const _WAY := 10000.0
const _FAR_AWAY := 1e12

const _WIDTH := 800.0
const _HEIGHT := 600.0
const _RADIUS := 10.0
# The slope of the path: no simple fraction.
const _ACROSS := 0.8387
const _DOWN := 0.5446


## See [method StabilityFamily.cases].
func cases() -> Array[StabilityCase]:
	var found: Array[StabilityCase] = []
	for speed in _SPEEDS:
		var title := tr("Speed %s px/s, 10 000 px among walls") % NumberText.short(speed)
		found.append(_case(title, tr("end within 1e-9 px"), _try_speed.bind(speed)))
	for radius in _RADII:
		var title := tr("Radius %s px, through a box 50 times") % NumberText.short(radius)
		var criterion := tr("end within 1e-12 of the box's width")
		found.append(_case(title, criterion, _try_radius.bind(radius)))
	found.append(_far_away())
	for seconds in _STEPS:
		var title := tr("%d steps of %s s") % [_STEPS_MADE, NumberText.short(seconds)]
		var criterion := tr("the bits of one step; end within 1e-9 px")
		found.append(_case(title, criterion, _try_step.bind(seconds)))
	return found


func _far_away() -> StabilityCase:
	return _case(
		tr("The world moved by 1e12 px, 10 000 px among walls"),
		tr("as many bounces; end within 64 last places of 1e12"),
		_try_far_away
	)


func _try_speed(_is_quick: bool, speed: float) -> StabilityResult:
	var world := _box_world(_WIDTH, _HEIGHT, speed, _RADIUS)
	_need(world.advance(_WAY / speed))
	return _at_most(_error_of_end(world, _WIDTH, _HEIGHT, speed, _RADIUS), 1e-9, "px")


func _try_radius(_is_quick: bool, radius: float) -> StabilityResult:
	var width := maxf(_WIDTH, 8.0 * radius)
	var height := maxf(_HEIGHT, 6.0 * radius)
	var world := _box_world(width, height, width, radius)
	_need(world.advance(50.0))
	var error := _error_of_end(world, width, height, width, radius)
	return _at_most(error / width, 1e-12)


func _try_far_away(_is_quick: bool) -> StabilityResult:
	var near := _box_world(_WIDTH, _HEIGHT, 500.0, _RADIUS)
	var shift := Vec2.new(_FAR_AWAY, -_FAR_AWAY)
	var high := Vec2.new(_WIDTH, _HEIGHT).plus(shift)
	var ball := _box_ball(_WIDTH, _HEIGHT, 500.0, _RADIUS)
	ball.position.add(shift)
	var far := _world(_rectangle(shift, high), [ball])
	_need(near.advance(_WAY / 500.0))
	_need(far.advance(_WAY / 500.0))
	var error := far.position(0).minus(shift).distance_to(near.position(0))
	var in_places := error / LastPlace.unit_of(_FAR_AWAY)
	var figure := tr("bounces: %d and %d, end off by %s last places")
	figure = figure % [near.impacts, far.impacts, NumberText.short(in_places)]
	return StabilityResult.new(figure, near.impacts == far.impacts and in_places <= 64.0)


# The ball moves the same way for every step length.
func _try_step(_is_quick: bool, seconds: float) -> StabilityResult:
	var speed := _WAY / (_STEPS_MADE * seconds)
	var stepped := _box_world(_WIDTH, _HEIGHT, speed, _RADIUS)
	var at_once := _box_world(_WIDTH, _HEIGHT, speed, _RADIUS)
	for step in _STEPS_MADE:
		_need(stepped.advance_to((step + 1) * seconds))
	_need(at_once.advance_to(_STEPS_MADE * seconds))
	var apart := stepped.position(0).distance_to(at_once.position(0))
	var error := _error_of_end(stepped, _WIDTH, _HEIGHT, speed, _RADIUS)
	var figure := tr("%s px from one step, end off by %s px")
	figure = figure % [NumberText.size(apart), NumberText.size(error)]
	return StabilityResult.new(figure, apart == 0.0 and error <= 1e-9)


func _box_world(width: float, height: float, speed: float, radius: float) -> EventWorld:
	var box := _rectangle(Vec2.new(), Vec2.new(width, height))
	return _world(box, [_box_ball(width, height, speed, radius)])


func _box_ball(width: float, height: float, speed: float, radius: float) -> Ball:
	return _ball(width * 0.375, height * 0.25, _ACROSS * speed, _DOWN * speed, radius)


# The distance of the ball from its exact position by unfolding.
func _error_of_end(
	world: EventWorld, width: float, height: float, speed: float, radius: float
) -> float:
	var x := _folded(width * 0.375 + _ACROSS * speed * world.time, radius, width - radius)
	var y := _folded(height * 0.25 + _DOWN * speed * world.time, radius, height - radius)
	return world.position(0).distance_to(Vec2.new(x, y))


# The position of a point that moved to [param place], folded back between two walls.
func _folded(place: float, low: float, high: float) -> float:
	var there_and_back := 2.0 * (high - low)
	var way := fposmod(place - low, there_and_back)
	return low + minf(way, there_and_back - way)
