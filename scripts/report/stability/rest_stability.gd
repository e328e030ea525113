class_name RestStability
extends StabilityFamily
## Balls that gravity presses against something for a long time: they must lie, slide or roll on it,
## and neither sink in nor bounce for ever.

const _GRAVITY := 500.0
const _RADIUS := 10.0


## See [method StabilityFamily.cases].
func cases() -> Array[StabilityCase]:
	return [
		_case(
			tr("Put on a floor so that it just touches, C = 1"),
			tr("slides on, height within 1e-12 px"),
			_try_put_on_floor
		),
		_case(
			tr("Lying on a slope, and everything around is changed 50 times"),
			tr("distance from the slope within 1e-9 px"),
			_try_changes
		),
		_case(
			tr("Dropped between two slopes, C = 0.5"),
			tr("lies still within 20 s, after less than 1000 bounces"),
			_try_corner
		),
		_case(
			tr("Slowly over the end of a segment"),
			tr("never more than 1e-7 px into the end"),
			_try_end
		),
		_case(
			tr("Three balls dropped on top of each other, C = 0"),
			tr("never more than 1e-9 px into each other, less than 5000 impacts in 1 s"),
			_try_stack
		),
	]


func _try_put_on_floor(_is_quick: bool) -> StabilityResult:
	var world := _falling([_segment(-90.0, 0.0, 900.0, 0.0)], [_lying(0.0, 70.0)], 1.0)
	_need(world.advance(5.0))
	var off := world.position(0).distance_to(Vec2.new(350.0, -_RADIUS))
	return StabilityResult.new("%s px" % NumberText.size(off), off <= 1e-12 and world.is_resting(0))


func _try_changes(_is_quick: bool) -> StabilityResult:
	var along := Vec2.unit_degrees(20.0)
	var slope := LineSegment.new(along.scaled(-9000.0), along.scaled(9000.0))
	var start := along.normal().scaled(-_RADIUS - 20.0)
	var world := _falling([slope], [Ball.new(start, _RADIUS)], 0.3)
	_need(world.advance(3.0))
	var worst := 0.0
	for change in 50:
		_need(world.set_gravity(Vec2.new(-200.0 + 10.0 * change, _GRAVITY)))
		_need(world.move_segment(0, slope))
		_need(world.change_ball(0, world.ball(0)))
		_need(world.advance(0.05))
		var place := world.position(0)
		worst = maxf(worst, absf(slope.closest_point(place).distance_to(place) - _RADIUS))
	return _at_most(worst, 1e-9, "px")


func _try_corner(_is_quick: bool) -> StabilityResult:
	var sides: Array[LineSegment] = [
		_segment(-200.0, -100.0, 0.0, 0.0), _segment(0.0, 0.0, 200.0, -100.0)
	]
	var world := _falling(sides, [_ball(30.0, -150.0, 0.0, 0.0, _RADIUS)], 0.5)
	_need(world.advance(20.0))
	var is_still := world.next_event_time() == INF and world.velocity(0).length() == 0.0
	var figure := tr("bounces: %d, x = %s px")
	figure = figure % [world.impacts, NumberText.short(world.position_x(0))]
	return StabilityResult.new(figure, is_still and world.impacts < 1000)


func _try_end(_is_quick: bool) -> StabilityResult:
	var world := _falling([_segment(-200.0, 0.0, 0.0, 0.0)], [_lying(-5.0, 20.0)], 0.5)
	var deepest := 0.0
	for step in 100:
		_need(world.advance(0.01))
		var place := world.position(0)
		if place.x > 0.0:
			deepest = maxf(deepest, _RADIUS - place.length())
	var is_beyond := world.position_y(0) > 2.0 * _RADIUS
	return StabilityResult.new("%s px" % NumberText.size(deepest), deepest <= 1e-7 and is_beyond)


func _try_stack(_is_quick: bool) -> StabilityResult:
	var balls: Array[Ball] = []
	for place in 3:
		balls.append(_ball(0.0, -_RADIUS - 22.0 * place, 0.0, 0.0, _RADIUS))
	var world := _falling([_segment(-90.0, 0.0, 90.0, 0.0)], balls, 0.0)
	var deepest := 0.0
	for step in 10:
		_need(world.advance(0.1))
		for upper: int in [1, 2]:
			var apart := world.position(upper).distance_to(world.position(upper - 1))
			deepest = maxf(deepest, 2.0 * _RADIUS - apart)
	var figure := tr("impacts: %d, at most %s px into each other")
	figure = figure % [world.impacts, NumberText.size(deepest)]
	return StabilityResult.new(figure, deepest <= 1e-9 and world.impacts < 5000)


func _falling(sides: Array[LineSegment], balls: Array[Ball], bounciness: float) -> EventWorld:
	var world := _world(sides, balls)
	_need(world.set_bounciness(bounciness))
	_need(world.set_gravity(Vec2.new(0.0, _GRAVITY)))
	return world


# A ball that lies on the x axis.
func _lying(x: float, speed: float) -> Ball:
	return _ball(x, -_RADIUS, speed, 0.0, _RADIUS)
