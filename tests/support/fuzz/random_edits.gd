class_name RandomEdits
extends RefCounted
## Balls that fly, touch, rest, slide and lie in corners among a few lines, and changes from outside
## that are aimed at them.

## What the balls are put on.
enum Scene { VALLEY, FLOOR, SLOPE, TABLE, SCATTERED }

const _MOST_LINES := 8

var _made := FuzzWorld.new()
var _rng: RandomNumberGenerator
# The lines as they are after the edits so far; null where one has been removed.
var _lines: Array[LineSegment] = []
var _ball_count := 0


## The world with this number; the same for the same number.
static func world_of(number: int) -> FuzzWorld:
	var maker := RandomEdits.new()
	maker._rng = FuzzKind.random(number)
	maker._lay(number % Scene.size() as Scene)
	maker._put_balls()
	maker._change()
	maker._rub()
	return maker._made


func _lay(scene: Scene) -> void:
	_made.gravity = Vec2.new(0.0, 300.0)
	if _rng.randf() < 0.15:
		_made.gravity = _some_gravity()
	_made.bounciness = [0.0, 0.5, 1.0, _rng.randf()][_rng.randi() % 4]
	_made.seconds = 1.0
	if _rng.randf() < 0.4:
		_made.walls = [Vec2.new(-250.0, -250.0), Vec2.new(250.0, 60.0)]
	var size := _rng.randf_range(50.0, 200.0)
	match scene:
		Scene.VALLEY:
			_add(Vec2.new(-size, -size * _rng.randf_range(0.05, 2.0)), Vec2.zero())
			_add(Vec2.zero(), Vec2.new(size, -size * _rng.randf_range(0.05, 2.0)))
		Scene.FLOOR:
			_add(Vec2.new(-size, 0.0), Vec2.new(size, 0.0))
		Scene.SLOPE:
			_add(Vec2.new(-size, 0.0), Vec2.new(size, size * _rng.randf_range(-0.5, 0.5)))
		Scene.TABLE:
			_add(Vec2.new(-size, 0.0), Vec2.zero())
			_add(Vec2.zero(), Vec2.new(_rng.randf_range(-20.0, 100.0), 80.0))
		Scene.SCATTERED:
			_add(_somewhere(), _somewhere())
	for extra: int in _rng.randi_range(0, 3):
		if _made.lines.size() < _MOST_LINES:
			_add(_somewhere(), _somewhere())
	_lines.assign(_made.lines)


func _add(from: Vec2, to: Vec2) -> void:
	_made.lines.append(LineSegment.new(from, to))


func _put_balls() -> void:
	_ball_count = 1 if _rng.randf() < 0.5 else _rng.randi_range(2, 6)
	for index: int in _ball_count:
		var radius := _rng.randf_range(3.0, 15.0)
		_made.balls.append(_ball_on(_made.lines[_rng.randi() % _made.lines.size()], radius))


# Most balls touch the line, at rest or along it; others fall onto it from somewhere.
func _ball_on(line: LineSegment, radius: float) -> Ball:
	var normal := line.normal()
	if normal.y > 0.0:
		normal = normal.negated()
	var at := line.start.lerped(line.end, _rng.randf())
	var height: float = [0.0, 0.0, _rng.randf_range(0.0, 3.0), _rng.randf_range(0.0, 60.0)][
		_rng.randi() % 4
	]
	at.add(normal.scaled(radius + height))
	var velocity := Vec2.zero()
	if _rng.randf() < 0.3:
		velocity = line.along().normalized().scaled(_rng.randf_range(-100.0, 100.0))
	elif height > 0.0 and _rng.randf() < 0.5:
		velocity = Vec2.random_unit(_rng).scaled(_rng.randf_range(0.0, 300.0))
	var mass: float = [1.0, 1.0, 10.0 ** _rng.randf_range(-2.0, 2.0)][_rng.randi() % 3]
	return Ball.new(at, radius, velocity, mass)


func _change() -> void:
	var time := 0.0
	for count: int in _rng.randi_range(1, 6):
		var is_at_event := _rng.randf() < 0.3
		if count == 0 or _rng.randf() < 0.7:
			time += [_rng.randf_range(0.0, 0.3), _rng.randf_range(0.0, 2.0)][_rng.randi() % 2]
		else:
			is_at_event = false
		var edit := _some_edit(time)
		edit.is_at_event = is_at_event
		_made.edits.append(edit)


# Where there is friction, it changes in place of C.
func _rub() -> void:
	FuzzKind.rub(_made, _rng)
	for edit: FuzzEdit in _made.edits:
		if _made.friction > 0.0 and edit.kind == FuzzEdit.Kind.BOUNCINESS:
			edit.kind = FuzzEdit.Kind.FRICTION
			edit.numbers[0] = [0.0, _rng.randf_range(0.0, 2.0)][_rng.randi() % 2]


func _some_edit(time: float) -> FuzzEdit:
	var chance := _rng.randf()
	if chance < 0.15:
		return _added_line(time)
	if chance < 0.5:
		return _changed_line(time)
	if chance < 0.75:
		return _changed_ball(time)
	return _changed_setting(time)


func _changed_setting(time: float) -> FuzzEdit:
	var chance := _rng.randf()
	if chance < 0.4:
		var gravity := _some_gravity()
		return FuzzEdit.of(FuzzEdit.Kind.GRAVITY, time, [gravity.x, gravity.y])
	if chance < 0.7:
		var bounciness: float = [0.0, 0.5, 1.0, _rng.randf()][_rng.randi() % 4]
		return FuzzEdit.of(FuzzEdit.Kind.BOUNCINESS, time, [bounciness])
	if chance < 0.8:
		return FuzzEdit.of(FuzzEdit.Kind.NO_WALLS, time)
	var bottom := _rng.randf_range(-20.0, 100.0)
	return FuzzEdit.of(FuzzEdit.Kind.WALLS, time, [-220.0, -260.0, 230.0, bottom])


func _added_line(time: float) -> FuzzEdit:
	var line := LineSegment.new(_near_ball(), _near_ball())
	if _rng.randf() < 0.3:
		line.start = _made.lines[0].end.copy()
	_lines.append(line)
	return FuzzEdit.of(FuzzEdit.Kind.ADD_LINE, time, FuzzWorld.numbers_of_line(line))


func _changed_line(time: float) -> FuzzEdit:
	var place := _rng.randi() % _lines.size()
	if not _lines[place] or _rng.randf() < 0.3:
		_lines[place] = null
		return FuzzEdit.of(FuzzEdit.Kind.REMOVE_LINE, time, [], place)
	var line := _lines[place].copy()
	var way := _some_way()
	line.start.add(way)
	line.end.add(way if _rng.randf() < 0.6 else _some_way())
	_lines[place] = line
	return FuzzEdit.of(FuzzEdit.Kind.MOVE_LINE, time, FuzzWorld.numbers_of_line(line), place)


func _changed_ball(time: float) -> FuzzEdit:
	var place := _rng.randi() % _ball_count
	var chance := _rng.randf()
	if chance < 0.15:
		return FuzzEdit.of(FuzzEdit.Kind.REMOVE_BALL, time, [], place)
	if chance < 0.35:
		_ball_count += 1
		var line := _made.lines[_rng.randi() % _made.lines.size()]
		var ball := _ball_on(line, _rng.randf_range(3.0, 15.0))
		return FuzzEdit.of(FuzzEdit.Kind.ADD_BALL, time, FuzzWorld.numbers_of_ball(ball))
	var way := Vec2.zero() if _rng.randf() < 0.5 else _some_way()
	var growth: float = [
		1.0, 1.0 + 10.0 ** _rng.randf_range(-12.0, 0.0), _rng.randf_range(0.3, 1.0)
	][_rng.randi() % 3]
	var push := Vec2.zero()
	if _rng.randf() < 0.3:
		push = Vec2.random_unit(_rng).scaled(_rng.randf_range(0.0, 200.0))
	return FuzzEdit.of(
		FuzzEdit.Kind.CHANGE_BALL, time, [way.x, way.y, growth, push.x, push.y], place
	)


# From 1e-12 to 100 px in any direction or straight up or down, sometimes far away.
func _some_way() -> Vec2:
	var size := 10.0 ** _rng.randf_range(-12.0, 2.0)
	if _rng.randf() < 0.1:
		size = 10_000.0
	var way := Vec2.random_unit(_rng)
	if _rng.randf() < 0.3:
		way = Vec2.new(0.0, -1.0 if _rng.randf() < 0.7 else 1.0)
	return way.scaled(size)


func _some_gravity() -> Vec2:
	match _rng.randi() % 4:
		0:
			return Vec2.zero()
		1:
			return Vec2.new(0.0, -300.0)
		2:
			return Vec2.new(0.0, 500.0)
	return Vec2.random_unit(_rng).scaled(_rng.randf_range(10.0, 600.0))


# Balls that touch a line at the start often rest there later.
func _near_ball() -> Vec2:
	var ball := _made.balls[_rng.randi() % _made.balls.size()]
	return ball.position.plus(Vec2.random_unit(_rng).scaled(_rng.randf_range(0.0, 80.0)))


func _somewhere() -> Vec2:
	return Vec2.new(_rng.randf_range(-200.0, 200.0), _rng.randf_range(-150.0, 50.0))
