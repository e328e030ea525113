class_name ChainKind
extends FuzzKind
## A ball on a random chain of lines in the event world: time goes on, the ball is never inside a
## line, and its energy never grows. It is kept where nothing takes it.

const _SAMPLES := 60


func _init() -> void:
	name = "chains"


func world_of(number: int) -> FuzzWorld:
	var made := RandomChain.world_of(number)
	rub(made, random(-number))
	return made


func problem_of(world: FuzzWorld) -> String:
	var flight := world.event_world()
	if starts_inside(world, flight):
		return ""
	var energy := EnergyCheck.new()
	energy.keeps_all = world.bounciness == 1.0 and world.friction == 0.0
	for sample: int in _SAMPLES + 1:
		var found := flight.fly_to(world.seconds * sample / _SAMPLES)
		# Hops of a perfectly elastic ball are a case for patience.
		if not found and flight.impacts > MOST_IMPACTS:
			return ""
		for ball: Ball in balls_of(flight):
			found = (found if found else InsideCheck.problem(ball, flight.nearest_points(ball)))
			found = found if found else energy.problem([ball], world.gravity)
		if found:
			return found
	return ""
