class_name SteppedChainKind
extends FuzzKind
## A ball on a random chain of lines, moved frame by frame. [WholeFrameMover] keeps all that the
## event world keeps but the energy, of which it may lose some. The two simple ways of the lecture
## promise less: they do not refuse, and their numbers stay finite.

const _FRAMES_PER_SECOND := 60.0
# Shorter ways are those of a ball that lies on a line, in pixels a frame.
const _LEAST_WAY := 0.1


func _init(with_method: SteppingMethods.Method) -> void:
	method = with_method
	name = "chains_" + AngledLinesLink.METHODS[method]


func world_of(number: int) -> FuzzWorld:
	return RandomChain.world_of(number)


func problem_of(world: FuzzWorld) -> String:
	# Frame by frame a ball far away is lost.
	if world.balls.is_empty() or not SteppedWorld.reaches(world.balls[0].position):
		return ""
	if starts_inside(world, world.event_world()):
		return ""
	var stepped := world.stepped_world(SteppingMethods.mover_of(method))
	var energy := EnergyCheck.new()
	var found := energy.problem(stepped.balls, world.gravity)
	for frame: int in roundi(_FRAMES_PER_SECOND * world.seconds):
		var before := stepped.balls[0].position.copy()
		found = stepped.step(1.0 / _FRAMES_PER_SECOND)
		if not found and stepped.is_lost[0]:
			return ""
		var ball := stepped.balls[0]
		if not found and not (ball.position.is_finite() and ball.velocity.is_finite()):
			found = "The ball is at %s with v = %s." % [ball.position, ball.velocity]
		if not found and method == SteppingMethods.Method.WHOLE_FRAME:
			found = _problem_of_frame(world, ball, before, energy)
		if found:
			return found
	return ""


func _problem_of_frame(world: FuzzWorld, ball: Ball, before: Vec2, energy: EnergyCheck) -> String:
	var found := energy.problem([ball], world.gravity)
	if not found:
		found = InsideCheck.problem(ball, InsideCheck.points_of(world.lines, ball))
	# A quick ball that bounces without loss can come back to where it was.
	var way := ball.velocity.length() / _FRAMES_PER_SECOND
	var is_still := ball.position.distance_to(before) < 1e-3 * way
	if not found and is_still and way > _LEAST_WAY and world.bounciness < 1.0:
		found = "The ball stands still at %s with v = %s." % [ball.position, ball.velocity]
	return found
