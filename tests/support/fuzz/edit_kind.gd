class_name EditKind
extends FuzzKind
## Balls among lines that are changed from outside while time goes on. After every change the world
## goes on as one that is built afresh from the places and velocities alone, to the last bit; no
## ball is inside a line or wall, unless there is no room for it or it was put there; between
## changes no energy comes from anywhere, and time goes on.
##
## A change that the world refuses must change nothing; which changes it refuses is not asked here.

# Nothing that is this far in the future is waited for, in seconds.
const _LONGEST_WAIT := 1.0


func _init() -> void:
	name = "edits"


func world_of(number: int) -> FuzzWorld:
	return RandomEdits.world_of(number)


func problem_of(world: FuzzWorld) -> String:
	var flight := world.event_world()
	if starts_inside(world, flight):
		return ""
	flight.keeps_events = true
	var judge := EditJudge.new(flight)
	var what := ""
	for edit: FuzzEdit in world.edits:
		var found := judge.problem_until(edit.time)
		if not found and edit.is_at_event and flight.next_event_time() < edit.time + _LONGEST_WAIT:
			found = judge.problem_until(flight.next_event_time())
		if not found:
			found = judge.problem_of_end()
		if found or flight.impacts > MOST_IMPACTS:
			return what + found if found else ""
		if not edit.apply(flight):
			what = "After %s: " % FuzzEdit.Kind.keys()[edit.kind]
			var is_new := edit.kind == FuzzEdit.Kind.ADD_BALL
			judge.begin_anew(flight.ball_count() - 1 if is_new else -1)
	var last := judge.problem_until(flight.time + world.seconds)
	if not last:
		last = judge.problem_of_end()
	return what + last if last else ""
