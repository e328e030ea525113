class_name SeamStability
extends StabilityFamily
## Floors of many segments, and gaps that a ball just fits through.

const _PIECES := 1000
const _QUICK_PIECES := 60
const _PIECE_LENGTH := 8.0
const _RADIUS := 10.0
const _GAP := 1e-12
# The limit of impacts for a case with 10^12 of them, in place of the world's own of a million.
const _MOST_IMPACTS := 2000


## See [method StabilityFamily.cases].
func cases() -> Array[StabilityCase]:
	return [
		_row_case(
			tr("Sliding over %d segments in a row, with gravity"),
			tr("no hop above 1e-9 px, speed within 1e-12"),
			_try_sliding
		),
		_row_case(
			tr("Flying along %d segments in a row, just touching"),
			tr("no impact, straight on to the last bit"),
			_try_touching
		),
		_row_case(
			tr("Bouncing over %d segments in a row, onto every seam"),
			tr("one bounce a segment, speed along within 1e-12"),
			_try_bouncing
		),
		_case(
			tr("Between parallel walls 2 r + 1e-12 px apart, 1e-9 px/s across"),
			tr("1000 bounces within 2 %, out with the energy within 1e-12"),
			_try_narrow
		),
		_case(
			tr("Between parallel walls 2 r + 1e-12 px apart, 1 px/s across"),
			tr("refused with a sentence: 10^12 bounces a second"),
			_try_too_narrow
		),
	]


# A case whose [param title] has a place for the number of segments.
func _row_case(title: String, criterion: String, trial: Callable) -> StabilityCase:
	return _case(title % _PIECES, criterion, trial).with_quick_form(title % _QUICK_PIECES)


# The ball lies on the first segment and has a speed along the floor.
func _try_sliding(is_quick: bool) -> StabilityResult:
	var count := _QUICK_PIECES if is_quick else _PIECES
	var world := _world(_floor(count), [_ball(4.0, -_RADIUS, 100.0, 0.0, _RADIUS)])
	_need(world.set_gravity(Vec2.new(0.0, 1000.0)))
	_need(world.set_bounciness(0.5))
	var hop := 0.0
	for step in count:
		_need(world.advance(0.99 * _PIECE_LENGTH / 100.0))
		hop = maxf(hop, absf(world.position_y(0) + _RADIUS))
	var lost := absf(world.velocity(0).x / 100.0 - 1.0)
	var figure := tr("hop %s px, speed off by %s, at x = %s px")
	var x := world.position_x(0)
	figure = figure % [NumberText.size(hop), NumberText.size(lost), NumberText.short(x, 6)]
	var has_arrived := x > 0.98 * count * _PIECE_LENGTH
	return StabilityResult.new(figure, hop <= 1e-9 and lost <= 1e-12 and has_arrived)


func _try_touching(is_quick: bool) -> StabilityResult:
	var count := _QUICK_PIECES if is_quick else _PIECES
	var world := _world(_floor(count), [_ball(-80.0, -_RADIUS, 1000.0, 0.0, _RADIUS)])
	_need(world.advance(10.0))
	var off := world.position(0).distance_to(Vec2.new(9920.0, -_RADIUS))
	var figure := tr("impacts: %d, %s px off") % [world.impacts, NumberText.size(off)]
	return StabilityResult.new(figure, world.impacts == 0 and off == 0.0)


# The ball falls for half a second. Then each bounce takes one second, in which it passes one
# segment.
func _try_bouncing(is_quick: bool) -> StabilityResult:
	var count := _QUICK_PIECES if is_quick else _PIECES
	var world := _world(_floor(count), [_ball(4.0, -_RADIUS - 32.0, _PIECE_LENGTH, 0.0, _RADIUS)])
	_need(world.set_gravity(Vec2.new(0.0, 256.0)))
	_need(world.advance(count - 1.0))
	var along := absf(world.velocity(0).x / _PIECE_LENGTH - 1.0)
	var figure := tr("bounces: %d, speed along off by %s") % [world.impacts, NumberText.size(along)]
	return StabilityResult.new(figure, world.impacts == count - 1 and along <= 1e-12)


func _try_narrow(_is_quick: bool) -> StabilityResult:
	var world := _channel(1e-9)
	var energy := world.energy()
	_need(world.advance(1.0))
	var in_between := absf(world.position_y(0)) <= _GAP
	_need(world.advance(1.0))
	var lost := absf(world.energy() / energy - 1.0)
	var figure := tr("bounces: %d, energy off by %s") % [world.impacts, NumberText.size(lost)]
	var is_counted := absi(world.impacts - 1000) <= 20
	return StabilityResult.new(figure, is_counted and in_between and lost <= 1e-12)


func _try_too_narrow(_is_quick: bool) -> StabilityResult:
	var world := _channel(1.0)
	world.most_impacts_per_second = _MOST_IMPACTS
	var sentence := world.advance(1.0)
	var is_inside := absf(world.position_y(0)) <= _GAP and world.time < 1.0
	return StabilityResult.new(sentence, sentence != "" and is_inside)


# A ball that flies to the right with 1000 px/s between two walls that are 1000 px long.
func _channel(speed_across: float) -> EventWorld:
	var half := _RADIUS + 0.5 * _GAP
	return _world(
		[_segment(0.0, -half, 1000.0, -half), _segment(0.0, half, 1000.0, half)],
		[_ball(0.0, 0.0, 1000.0, speed_across, _RADIUS)]
	)


func _floor(count: int) -> Array[LineSegment]:
	var pieces: Array[LineSegment] = []
	for piece in count:
		var x := _PIECE_LENGTH * piece
		pieces.append(_segment(x, 0.0, x + _PIECE_LENGTH, 0.0))
	return pieces
