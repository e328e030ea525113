class_name ShotStability
extends StabilityFamily
## Nothing ever passes through a wall: shots at every speed inside closed rooms. And a reversed
## flight retraces its path.

const _SHOTS := 1000000
const _QUICK_SHOTS := 200
const _RADIUS := 5.0
# The longest way of a shot in pixels; the room is about 600 px wide.
const _LONGEST_WAY := 800.0
const _BOUNCES_BACK := 30
# The limit of impacts for a case with millions of them, in place of the world's own of a million.
const _MOST_IMPACTS := 1000


## See [method StabilityFamily.cases].
func cases() -> Array[StabilityCase]:
	var title := tr("%s random shots at 1e-3 to 1e9 px/s in a closed star of 14 segments")
	var criterion := tr("no ball ever outside, or closer to a segment than r - 1e-9 px")
	return [
		_case(title % "10^6", criterion, _try_shots).with_quick_form(title % _QUICK_SHOTS),
		_case(
			tr("A shot so fast that it would bounce millions of times a second"),
			tr("refused with a sentence, still in the room"),
			_try_too_fast
		),
		_case(
			tr("Turned round after 30 bounces among angled lines"),
			tr("back at the start within 1e-8 px"),
			_try_reversed
		),
	]


# Each shot begins where the last one ended, so that a ball that gets out stays outside and is
# noticed.
func _try_shots(is_quick: bool) -> StabilityResult:
	var room := StarRoom.new()
	var ball := _ball(0.0, 0.0, 0.0, 0.0, _RADIUS)
	var world := _world(room.sides, [ball])
	var rng := RandomNumberGenerator.new()
	rng.seed = 20
	var sunk := 0.0
	for shot in _QUICK_SHOTS if is_quick else _SHOTS:
		var speed := pow(10.0, rng.randf_range(-3.0, 9.0))
		var angle := rng.randf_range(-PI, PI)
		ball.position.set_xy(world.position_x(0), world.position_y(0))
		ball.velocity.set_xy(speed * cos(angle), speed * sin(angle))
		_need(world.change_ball(0, ball))
		_need(world.advance(rng.randf() * _LONGEST_WAY / speed))
		var depth := room.depth_of(world.position_x(0), world.position_y(0))
		sunk = maxf(sunk, INF if is_nan(depth) else _RADIUS - depth)
	var figure := tr("impacts: %d, at most %s px into a segment")
	figure = figure % [world.impacts, NumberText.size(sunk)]
	return StabilityResult.new(figure, sunk <= 1e-9)


func _try_too_fast(_is_quick: bool) -> StabilityResult:
	var room := StarRoom.new()
	var world := _world(room.sides, [_ball(0.0, 0.0, 1e9, 1e8, _RADIUS)])
	world.most_impacts_per_second = _MOST_IMPACTS
	var sentence := world.advance(1.0)
	var depth := room.depth_of(world.position_x(0), world.position_y(0))
	var is_inside := depth >= _RADIUS - 1e-9 and world.time < 1.0
	return StabilityResult.new(sentence, sentence != "" and is_inside)


# A convex room without lines in it: at the end of a line, an error would grow by a factor of 10 or
# more.
func _try_reversed(_is_quick: bool) -> StabilityResult:
	var lines := _polygon(
		[
			Vec2.new(0.0, 40.0),
			Vec2.new(380.0, 0.0),
			Vec2.new(800.0, 60.0),
			Vec2.new(760.0, 560.0),
			Vec2.new(420.0, 600.0),
			Vec2.new(30.0, 530.0),
		]
	)
	lines.append(_segment(180.0, 420.0, 320.0, 330.0))
	lines.append(_segment(470.0, 180.0, 640.0, 260.0))
	lines.append(_segment(500.0, 470.0, 620.0, 400.0))
	var start := _ball(120.0, 130.0, 431.0, 277.0, 10.0)
	var world := _world(lines, [start])
	while world.impacts < _BOUNCES_BACK and refusal == "":
		_need(world.advance_to_next_event())
	_need(world.advance(0.01))
	var seconds := world.time
	var back := world.ball(0)
	back.velocity.scale(-1.0)
	_need(world.change_ball(0, back))
	_need(world.advance(seconds))
	var off := world.position(0).distance_to(start.position)
	var figure := tr("%d bounces there and back, %s px off") % [world.impacts, NumberText.size(off)]
	return StabilityResult.new(figure, off <= 1e-8 and world.impacts >= 2 * _BOUNCES_BACK)
