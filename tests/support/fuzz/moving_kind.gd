class_name MovingKind
extends FuzzKind
## Balls among lines of which some move, with a constant velocity, to and fro or about a pivot, or
## run as belts: time goes on, no ball is inside anything unless it is crushed, and each push of a
## line takes energy away as seen from its surface. One long step gives the same bits as many short
## ones, and the same world in a frame that moves does the same.

## How many steps are the short ones.
const STEPS := 48
## In another frame the places are the same up to this, in pixels, and to what a fast line does with
## its last places: see _frame_error.
const FRAME_ERROR := 1e-8
## So many impacts are compared in another frame: after each one the error of a place grows.
const MOST_IN_FRAME := 3

# What rounding adds to an energy, as a share of the largest.
const _ROUNDING := 1e-9
# px/s.
const _FAST := 1e5
# A meeting with a segment that turns takes 1 ms to find.
const _PATIENCE := 3000
const _WIND_X := 70.0
const _WIND_Y := -40.0

var _crushed := 0
var _compared := 0
var _judged := 0


func _init() -> void:
	name = "moving"


func figures() -> String:
	var counts := [_judged, _crushed, _compared]
	return "moving: %d worlds judged, %d balls crushed, %d worlds in another frame" % counts


func world_of(number: int) -> FuzzWorld:
	var rng := random(number)
	var made := FuzzWorld.new()
	made.bounciness = [1.0, 0.5, 0.0, 0.9, rng.randf()][rng.randi() % 5]
	made.friction = [0.0, 0.0, 0.1, 0.5, rng.randf_range(0.0, 2.0)][rng.randi() % 5]
	made.seconds = 2.0 ** rng.randi_range(-1, 1)
	if rng.randf() < 0.75:
		made.gravity = Vec2.new(0.0, 300.0 if rng.randf() < 0.5 else 600.0)
	if rng.randf() < 0.5:
		made.walls = [Vec2.zero(), Vec2.new(300.0, 200.0)]
	for place: int in rng.randi_range(1, 5):
		made.lines.append(_line(made, rng))
	for index: int in rng.randi_range(1, 4):
		made.balls.append(_ball(made, rng))
	for place: int in made.lines.size():
		_add_motion(made, place, rng)
	return made


func problem_of(world: FuzzWorld) -> String:
	if not world.edits.all(func(edit: FuzzEdit) -> bool: return edit.time == 0.0):
		return ""
	var flight := _begun(world)
	if not flight or _problem_now(flight):
		return ""
	_judged += 1
	flight.keeps_events = true
	for step: int in STEPS:
		var found := flight.fly_to(world.seconds * (step + 1) / STEPS)
		if found and not flight.stands_still and _fastest(flight) > _FAST:
			return ""
		found = found if found else _problem_now(flight)
		for event: WorldEvent in flight.events:
			found = found if found else _problem_of_event(world, flight, event)
		flight.events.clear()
		if found:
			return found
		if flight.impacts > _PATIENCE:
			return ""
	for index: int in flight.ball_count():
		_crushed += int(flight.is_crushed(index))
	return _problem_of_other_ways(world, flight)


func _line(made: FuzzWorld, rng: RandomNumberGenerator) -> LineSegment:
	if made.lines and rng.randf() < 0.4:
		# A chain goes on.
		var from := made.lines[-1].end
		var turn := rng.randf_range(-0.5, 0.5)
		return LineSegment.new(from, from.plus(Vec2.unit_radians(turn).scaled(60.0)))
	var start := Vec2.new(rng.randf_range(0.0, 250.0), rng.randf_range(50.0, 200.0))
	var angle: float = [0.0, rng.randf_range(-0.8, 0.8), PI / 2.0, rng.randf() * TAU][
		rng.randi() % 4
	]
	var along := Vec2.unit_radians(angle)
	return LineSegment.new(start, start.plus(along.scaled(rng.randf_range(20.0, 200.0))))


# Some lie on a line.
func _ball(made: FuzzWorld, rng: RandomNumberGenerator) -> Ball:
	var radius := rng.randf_range(3.0, 15.0)
	var at := Vec2.new(rng.randf_range(20.0, 280.0), rng.randf_range(20.0, 180.0))
	var velocity := Vec2.random_unit(rng).scaled(rng.randf_range(0.0, 300.0))
	var spin: float = [0.0, rng.randf_range(-60.0, 60.0)][rng.randi() % 2]
	if rng.randf() < 0.4:
		var line := made.lines[rng.randi() % made.lines.size()]
		at = line.start.lerped(line.end, rng.randf()).minus(line.normal().scaled(radius))
		velocity = line.along().normalized().scaled(rng.randf_range(-50.0, 50.0))
	return Ball.new(at, radius, velocity, 1.0, spin)


func _add_motion(made: FuzzWorld, place: int, rng: RandomNumberGenerator) -> void:
	var fast: float = [1.0, 1.0, 1.0, 1.0, 1.0, 10.0, 1e3, 1e6][rng.randi() % 8]
	var velocity := Vec2.random_unit(rng).scaled(rng.randf_range(0.0, 150.0) * fast)
	if rng.randf() < 0.4:
		velocity = Vec2.new(0.0, -velocity.length()) if rng.randf() < 0.5 else velocity
	var edit: FuzzEdit = null
	match rng.randi() % 5:
		0:
			edit = FuzzEdit.of(FuzzEdit.Kind.STEADY_LINE, 0.0, [velocity.x, velocity.y], place)
		1:
			var there := rng.randf_range(0.1, 1.0) / minf(fast, 30.0)
			var numbers: PackedFloat64Array = [velocity.x * there, velocity.y * there, there]
			numbers.append(there if rng.randf() < 0.5 else rng.randf_range(0.1, 1.0))
			edit = FuzzEdit.of(FuzzEdit.Kind.LINE_TO_AND_FRO, 0.0, numbers, place)
		2:
			var line := made.lines[place]
			var pivot := line.start.lerped(line.end, rng.randf_range(-0.2, 1.2))
			var turn: float = [0.01, 1.0, 1.0, 100.0][rng.randi() % 4]
			turn *= rng.randf_range(-5.0, 5.0)
			var numbers: PackedFloat64Array = [pivot.x, pivot.y, turn, 0.0, 0.0]
			edit = FuzzEdit.of(FuzzEdit.Kind.TURNING_LINE, 0.0, numbers, place)
	if edit:
		made.edits.append(edit)
	if made.friction > 0.0 and rng.randf() < 0.3:
		var speed := rng.randf_range(-200.0, 200.0)
		made.edits.append(FuzzEdit.of(FuzzEdit.Kind.BELT, 0.0, [speed], place))


# The world with its motions; null where one is refused.
static func _begun(world: FuzzWorld) -> WatchedWorld:
	var made := world.event_world()
	for edit: FuzzEdit in world.edits:
		if edit.apply(made):
			return null
	made.most_impacts_per_second = MOST_IMPACTS
	return made if made.advance(0.0) == "" else null


func _problem_now(flight: WatchedWorld) -> String:
	var balls := balls_of(flight)
	for one: int in balls.size():
		# Far away from its start a segment has fewer digits.
		var allowed := maxf(PileKind.DEEPEST, 1e-15 * _farthest(flight))
		var found := InsideCheck.problem(balls[one], flight.nearest_points(balls[one]), allowed)
		if found:
			return found
		for other: int in one:
			var gap := balls[one].position.distance_to(balls[other].position)
			var inside := balls[one].radius + balls[other].radius - gap
			if inside > allowed:
				return "Two balls are inside each other by %s px." % inside
	return ""


# What moves so fast in a room has more impacts than anybody can wait for.
static func _fastest(flight: WatchedWorld) -> float:
	var fastest := 0.0
	for ball: Ball in balls_of(flight):
		fastest = maxf(fastest, ball.velocity.length())
	return fastest


static func _farthest(flight: WatchedWorld) -> float:
	var farthest := 0.0
	for line: LineSegment in flight.lines():
		farthest = maxf(farthest, maxf(line.start.length(), line.end.length()))
	for ball: Ball in balls_of(flight):
		farthest = maxf(farthest, ball.position.length())
	return farthest


# What a line did to a ball: as seen from its surface there is no more energy than before.
func _problem_of_event(world: FuzzWorld, flight: WatchedWorld, event: WorldEvent) -> String:
	if event.kind != WorldEvent.Kind.SEGMENT or flight.is_crushed(event.ball):
		return ""
	var radius := flight.ball(event.ball).radius
	var least := INF
	for seen_from: Vec2 in _velocities_at(world, event):
		var before := _energy(event.velocity_before.minus(seen_from), radius * event.spin_before)
		var after := _energy(event.velocity_after.minus(seen_from), radius * event.spin_after)
		var fastest := seen_from.length_squared() + before + after
		least = minf(least, after - before - _ROUNDING * fastest)
	var hop := world.gravity.length() * BallPiles.LEAST_HOP
	for edit: FuzzEdit in world.edits:
		if edit.kind == FuzzEdit.Kind.TURNING_LINE and edit.place == event.other:
			var turn := absf(edit.numbers[2])
			var arm := event.point.distance_to(Vec2.new(edit.numbers[0], edit.numbers[1])) + radius
			var pressed := turn * turn * arm + 2.0 * turn * event.velocity_before.length()
			hop += (
				(pressed + 2.0 * turn * turn * arm)
				* minf(SurfaceFrame.HOP_TURN / turn, BallPiles.LEAST_HOP)
			)
	if not least <= hop * hop:
		return "A push adds an energy of %s." % least
	return ""


static func _energy(velocity: Vec2, edge: float) -> float:
	return 0.5 * velocity.length_squared() + 0.5 * Disc.INERTIA * edge * edge


# The velocities that the touched surface may have: before and after a turning point, with its belt
# and without.
static func _velocities_at(world: FuzzWorld, event: WorldEvent) -> Array[Vec2]:
	var found: Array[Vec2] = [Vec2.zero()]
	var line := world.lines[event.other]
	var speed := 0.0
	for edit: FuzzEdit in world.edits:
		if edit.place == event.other and edit.kind == FuzzEdit.Kind.BELT:
			speed = edit.numbers[0]
	var belt := line.along().normalized().scaled(speed)
	for edit: FuzzEdit in world.edits:
		if edit.place != event.other or edit.kind == FuzzEdit.Kind.BELT:
			continue
		found.clear()
		for moment: float in [event.time * (1.0 - 1e-12) - 1e-15, event.time]:
			var mover := SegmentMover.new(line, edit.motion(), 0.0, 0.0)
			mover.go_to(maxf(moment, 0.0), 0.0)
			found.append(mover.velocity_at(event.point))
			belt = mover.segment_now().along().normalized().scaled(speed)
	for velocity: Vec2 in found.duplicate():
		found.append(velocity.plus(belt))
		found.append(velocity.minus(belt))
	return found


func _problem_of_other_ways(world: FuzzWorld, flight: WatchedWorld) -> String:
	var long := _begun(world)
	long.keeps_events = true
	var found := long.fly_to(world.seconds)
	if found:
		return "In one step: " + found
	if EventWorlds.numbers(long) != EventWorlds.numbers(flight):
		return "One long step and many short ones differ."
	if world.walls or flight.impacts > MOST_IN_FRAME:
		return ""
	# Of what touches at the start, rounding decides whether it does.
	var begun := _begun(world)
	for ball: Ball in balls_of(begun):
		if InsideCheck.depth(ball, begun.nearest_points(ball)) > -PileKind.DEEPEST:
			return ""
	return _problem_in_frame(world, flight, Vec2.new(_WIND_X, _WIND_Y))


func _problem_in_frame(world: FuzzWorld, flight: WatchedWorld, wind: Vec2) -> String:
	var moved := world.copy()
	for ball: Ball in moved.balls:
		ball.velocity.add(wind)
	var other := moved.event_world()
	for place: int in world.lines.size():
		var motion := SegmentMotion.steady(wind)
		for edit: FuzzEdit in world.edits:
			if edit.kind == FuzzEdit.Kind.BELT and edit.place == place:
				Refusal.push(other.set_belt_speed(place, edit.numbers[0]))
			elif edit.place == place:
				motion = _in_frame(edit, wind, world.seconds)
		if not motion or other.set_segment_motion(place, motion):
			return ""
	var found := other.fly_to(world.seconds)
	if found:
		return "In a frame that moves: " + found
	_compared += 1
	for index: int in flight.ball_count():
		var there := other.position(index)
		if flight.is_crushed(index) != other.is_crushed(index):
			return "In a frame that moves another ball is crushed."
		if flight.is_crushed(index):
			continue
		there.subtract(wind.scaled(world.seconds))
		var error := there.distance_to(flight.position(index))
		if not error <= _frame_error(world, flight):
			return "In a frame that moves a ball is off by %s px." % error
	return ""


# The last places of a coordinate tilt the normal at a round end by their share of the radius, and
# what is hit by a line flies off with twice its speed at most.
static func _frame_error(world: FuzzWorld, flight: WatchedWorld) -> float:
	var fastest := _fastest(flight)
	for edit: FuzzEdit in world.edits:
		if edit.kind == FuzzEdit.Kind.LINE_TO_AND_FRO:
			var way := Vec2.new(edit.numbers[0], edit.numbers[1]).length()
			fastest = maxf(fastest, way / minf(edit.numbers[2], edit.numbers[3]))
		elif edit.kind == FuzzEdit.Kind.STEADY_LINE:
			fastest = maxf(fastest, Vec2.new(edit.numbers[0], edit.numbers[1]).length())
	var radius := INF
	for ball: Ball in world.balls:
		radius = minf(radius, ball.radius)
	var tilt := 16.0 * ImpactTable.EPSILON * _farthest(flight) / radius
	return maxf(FRAME_ERROR, 2.0 * tilt * fastest * world.seconds)


# The motion of a line as it is in a frame that moves; null where it has too many turning points.
static func _in_frame(edit: FuzzEdit, wind: Vec2, seconds: float) -> SegmentMotion:
	match edit.kind:
		FuzzEdit.Kind.TURNING_LINE:
			var pivot := Vec2.new(edit.numbers[0], edit.numbers[1])
			var velocity := wind.plus(Vec2.new(edit.numbers[3], edit.numbers[4]))
			return SegmentMotion.turning(pivot, edit.numbers[2], velocity)
		FuzzEdit.Kind.LINE_TO_AND_FRO:
			var period := edit.numbers[2] + edit.numbers[3]
			if period * 100.0 < seconds:
				return null
			var times: PackedFloat64Array = [0.0]
			var ways: Array[Vec2] = [Vec2.zero()]
			while times[-1] <= seconds:
				var start := times[-1]
				times.append_array([start + edit.numbers[2], start + period])
				var there := Vec2.new(edit.numbers[0], edit.numbers[1])
				ways.append(there.plus(wind.scaled(times[-2])))
				ways.append(wind.scaled(times[-1]))
			return SegmentMotion.along(times, ways)
	return SegmentMotion.steady(wind.plus(Vec2.new(edit.numbers[0], edit.numbers[1])))
