class_name EditJudge
extends RefCounted
## Looks at a world from one change from outside to the next, beside a world that was built afresh
## from the same places and velocities at the change.

## So many events after a change are compared.
const COMPARED_EVENTS := 100

const _SAMPLES_PER_SECOND := 20.0

var _flight: WatchedWorld
var _fresh: WatchedWorld
var _energy: EnergyCheck
# The balls that were inside something after the change, and may stay there: they have no room, or
# were put there.
var _squeezed: PackedInt32Array = []


func _init(flight: WatchedWorld) -> void:
	_flight = flight
	begin_anew()


## The world has been changed: from now on it is compared with what it is now. [param added] is the
## place of a ball that has just come: it is not pushed out of what it is inside.
func begin_anew(added: int = -1) -> void:
	_flight.events.clear()
	_fresh = _flight.afresh()
	_energy = EnergyCheck.new()
	_energy.allowed = EnergyCheck.of_hops(FuzzKind.balls_of(_flight), _flight.gravity())
	_squeezed = _balls_without_room(added)


## "" or what is wrong with the world until [param target], in seconds. What is squeezed may be
## thrown to and fro without end; so may balls that lines press into each other.
func problem_until(target: float) -> String:
	var start := _flight.time
	var end := maxf(target, start)
	# Where no time passes, what happens at this moment happens all the same.
	var samples := maxi(ceili((end - start) * _SAMPLES_PER_SECOND), 1)
	var found := _problem_now()
	for sample: int in samples:
		if not found:
			found = _flight.fly_to(minf(end, start + (sample + 1) / _SAMPLES_PER_SECOND))
		if not found:
			found = _problem_now()
	if found and _flight.stands_still:
		_squeezed.append_array(InsideCheck.jammed(_flight))
	return "" if _squeezed else found


## "" or in what the world differs from the one that was built afresh.
func problem_of_end() -> String:
	if _squeezed:
		return ""
	var found := _fresh.fly_to(_flight.time)
	if found:
		return "The world built afresh: " + found
	found = _problem_of_events()
	return found if found else _problem_of_places()


func _problem_now() -> String:
	var found := _energy.problem(FuzzKind.balls_of(_flight), _flight.gravity())
	for index: int in _flight.ball_places():
		if not found and not index in _squeezed:
			found = _problem_of_inside(index)
	return found


func _problem_of_inside(index: int) -> String:
	var ball := _flight.ball(index)
	return InsideCheck.problem(ball, _flight.nearest_points(ball))


func _balls_without_room(added: int) -> PackedInt32Array:
	var found: PackedInt32Array = []
	for index: int in _flight.ball_places():
		if _problem_of_inside(index):
			var was_put_there := index == added or index in _squeezed
			if was_put_there or not InsideCheck.has_room(_flight, index):
				found.append(index)
	return found


func _problem_of_events() -> String:
	var events := _flight.events
	for index: int in mini(events.size(), COMPARED_EVENTS):
		if index >= _fresh.events.size():
			return "Afresh there are fewer events: no %s." % _what(events[index])
		var other := _fresh.events[index]
		if _text_of(events[index], _flight) != _text_of(other, _fresh):
			return "An event is %s, but afresh %s." % [_what(events[index]), _what(other)]
	if events.size() < mini(_fresh.events.size(), COMPARED_EVENTS):
		return "Afresh there are more events: %s." % _what(_fresh.events[events.size()])
	return ""


func _problem_of_places() -> String:
	var now := FuzzKind.balls_of(_flight)
	var afresh := FuzzKind.balls_of(_fresh)
	for index: int in now.size():
		var text := FuzzWorld.ball_text(FuzzWorld.numbers_of_ball(now[index]))
		var other := FuzzWorld.ball_text(FuzzWorld.numbers_of_ball(afresh[index]))
		if text != other:
			return "The ball is %s, but afresh it is %s." % [text, other]
	return ""


# Places of what is there are counted, because afresh there are no empty ones. What a ball rests on
# or leaves may be a wall or a segment, which its number does not tell.
func _text_of(event: WorldEvent, world: WatchedWorld) -> String:
	var balls := world.ball_places()
	var other := event.other if event.kind == WorldEvent.Kind.WALL else -1
	if event.kind == WorldEvent.Kind.BALL:
		other = balls.find(event.other)
	elif event.kind == WorldEvent.Kind.SEGMENT:
		other = world.line_places().find(event.other)
	return "%d %d %s" % [balls.find(event.ball), other, _what(event)]


func _what(event: WorldEvent) -> String:
	var velocity := event.velocity_after
	return (
		"%s at %s s, v = %s"
		% [
			WorldEvent.Kind.keys()[event.kind],
			DecimalText.of(event.time),
			FuzzWorld.list_text([velocity.x, velocity.y])
		]
	)
