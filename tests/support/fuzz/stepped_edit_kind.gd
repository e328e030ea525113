class_name SteppedEditKind
extends FuzzKind
## One ball among lines that are changed from outside, in each of the four ways of stepping: after
## every change it is outside all lines, if there is room. Where whole frames are used, and in event
## worlds, it stays outside until the next change.

const _FRAMES_PER_SECOND := 60.0
# In a stepped world a ball that is inside a line by less than this, in pixels, touches it.
const _DEEPEST := 2e-6


func _init() -> void:
	name = "edits_frame_by_frame"


func world_of(number: int) -> FuzzWorld:
	var made := RandomEdits.world_of(number)
	made.walls.clear()
	made.balls.resize(mini(made.balls.size(), 1))
	return made


func problem_of(world: FuzzWorld) -> String:
	if world.balls.size() != 1 or not SteppedWorld.reaches(world.balls[0].position):
		return ""
	if starts_inside(world, world.event_world()):
		return ""
	for each: SteppingMethods.Method in SteppingMethods.Method.values():
		var found := _problem_of_method(world, each)
		if found:
			return "%s: %s" % [SteppingMethods.Method.keys()[each], found]
	return ""


func _problem_of_method(world: FuzzWorld, way: SteppingMethods.Method) -> String:
	var stepped := world.stepped_world(SteppingMethods.mover_of(way))
	var is_exact := (
		way == SteppingMethods.Method.WHOLE_FRAME or way == SteppingMethods.Method.EVENT_WORLD
	)
	# From now on it is pushed out of what is changed.
	stepped.push_out_balls()
	var found := ""
	var is_squeezed := false
	for edit: FuzzEdit in world.edits:
		while not found and stepped.frames < edit.time * _FRAMES_PER_SECOND:
			var refusal := stepped.step(1.0 / _FRAMES_PER_SECOND)
			# An elastic ball may make more of the lowest hops than a stepped world allows.
			if stepped.is_lost[0] or (refusal and (is_squeezed or _is_elastic(stepped))):
				return ""
			found = refusal
			if not found and is_exact and not is_squeezed:
				found = _problem_of_inside(stepped)
		if found:
			return found
		if edit.apply_stepped(stepped):
			continue
		stepped.push_out_balls()
		is_squeezed = not _has_room(world, stepped)
		if not is_squeezed:
			found = _problem_of_inside(stepped)
		if found:
			return "After %s: %s" % [FuzzEdit.Kind.keys()[edit.kind], found]
	return ""


func _problem_of_inside(stepped: SteppedWorld) -> String:
	var ball := stepped.balls[0]
	var points := InsideCheck.points_of(stepped.surroundings.segments, ball)
	return InsideCheck.problem(ball, points, _DEEPEST)


func _is_elastic(stepped: SteppedWorld) -> bool:
	return stepped.surroundings.bounciness > LastBounces.NEARLY_ELASTIC


func _has_room(world: FuzzWorld, stepped: SteppedWorld) -> bool:
	var now := world.copy()
	now.lines = stepped.surroundings.segments
	now.balls = stepped.balls
	return InsideCheck.has_room(now.event_world(), 0)
