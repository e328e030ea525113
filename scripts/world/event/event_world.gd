class_name EventWorld
extends BounceLaws
## Balls among segments and walls, moved from event to event: what happens next is predicted once,
## by exact formulas, and stays true until something changes. A world costs by the bounce, not by
## the frame, and is as exact for one long step as for many short ones.
##
## Segments work from both sides and have round ends, their caps; balls collide with each other; one
## gravity, bounciness and friction holds for all. After a change the world is as one that is built
## now: all flights begin anew, what overlaps is pushed out. Where a ball is now is answered by
## [EventState]; docs/event_world.md says where each law is.
##
## What cannot be taken is refused: each such method returns "" or one sentence with the value and
## what is allowed, and then nothing has changed.

## Coordinates, speeds, sizes, masses and gravity stay within this, in pixels, seconds and their
## quotients.
const LARGEST := WorldLimits.LARGEST

## The moment at which the world stands, in seconds. To set it lets time pass as
## [method advance_to] does, and puts all centres into [member EventState.places]: what a game asks
## each frame. A moment in the past, beyond 1e15 s or NAN pushes an error, and nothing changes;
## too many impacts push one, too, and moment tells where the world has stopped.
var moment: float:
	get:
		return time
	set(value):
		if value < _lone_until and value >= time:
			time = value
			_time_low = 0.0
			var seconds := (value - _lone_start) - _lone_start_low
			_places[0] = _lone_x + _lone_velocity_x * seconds
			_places[1] = _lone_y + _lone_velocity_y * seconds
		else:
			_go_to_moment(value)


## Balls keep inside this upright box from now on: its corners at the upper left and lower right.
func set_walls(low: Vec2, high: Vec2) -> String:
	var problem := WorldLimits.problem_of_walls(low, high)
	if problem:
		return problem
	_has_walls = true
	_left_x = low.x
	_top_y = low.y
	_right_x = high.x
	_bottom_y = high.y
	_change_contents()
	_push_out_all()
	return ""


## Takes the walls away.
func remove_walls() -> void:
	_has_walls = false
	_change_contents()


## Takes this gravity from now on, in px/s^2.
func set_gravity(gravity: Vec2) -> String:
	var problem := FreeFlight.problem_of_gravity(gravity, LARGEST)
	if problem:
		return problem
	_gravity_x = gravity.x
	_gravity_y = gravity.y
	_change_contents()
	return ""


## Takes this bounciness C from now on, 0..1, for all that bounces.
func set_bounciness(bounciness: float) -> String:
	var problem := Bounce.problem_of_bounciness(bounciness)
	if problem:
		return problem
	_bounciness = bounciness
	_change_contents()
	return ""


## Takes this friction µ from now on, 0..1e6, along all that balls touch: see docs/friction.md.
func set_friction(friction: float) -> String:
	var problem := Friction.problem_of(friction, WorldLimits.MOST_FRICTION)
	if problem:
		return problem
	_friction = friction
	_spins.set_friction(friction, time, _time_low)
	_change_contents()
	return ""


## How many places for segments there are, with those of removed ones.
func segment_count() -> int:
	return _segments.size()


## The segment at that place.
func segment(place: int) -> LineSegment:
	_segments.go_to(time, _time_low)
	return _segments.segment(place)


## Takes copies of these segments in place of the old ones.
func set_segments(new_segments: Array[LineSegment]) -> String:
	for new_segment in new_segments:
		var problem := new_segment.problem(LARGEST)
		if problem:
			return problem
	_set_uses_grid(uses_grid)
	for place in new_segments.size():
		_segments.put(place, new_segments[place])
	_change_contents()
	_push_out_all()
	return ""


## Adds a segment; its place is the old [method segment_count].
func add_segment(new_segment: LineSegment) -> String:
	var problem := new_segment.problem(LARGEST)
	if not problem:
		_segments.put(_segments.size(), new_segment)
		_change_contents()
		_push_out_of(_segments.size() - 1)
	return problem


## Moves the segment at that place. A ball that lies on it stays on its side.
func move_segment(place: int, new_segment: LineSegment) -> String:
	var problem := WorldLimits.problem_of_place(place, _segments.has_segment(place), "segment")
	if not problem:
		problem = new_segment.problem(LARGEST)
	if not problem:
		var sides := Overlaps.sides_of_touching(_balls(), segment(place), new_segment)
		_segments.put(place, new_segment)
		_change_contents()
		_push_out_of(place, sides)
	return problem


## Removes the segment at that place, which stays empty: the others keep their places.
func remove_segment(place: int) -> String:
	var problem := WorldLimits.problem_of_place(place, _segments.has_segment(place), "segment")
	if not problem:
		_segments.remove(place)
		_change_contents()
	return problem


## Lets the segment at that place move from now on; null ends its motion where it is now. A change
## of the segment itself ends it, too.
func set_segment_motion(place: int, motion: GivenMotion) -> String:
	var problem := WorldLimits.problem_of_place(place, _segments.has_segment(place), "segment")
	if not problem and motion:
		problem = motion.problem(LARGEST)
	if not problem:
		_segments.put(place, segment(place))
		if motion:
			_segments = motion.begin(_segments, place, time, _time_low)
		_change_contents()
	return problem


## Lets the surface of a segment run along it, as a belt does, with so many px/s from its start to
## its end, on both sides; its round ends rest. 0 ends it.
func set_belt_speed(place: int, speed: float) -> String:
	var problem := WorldLimits.problem_of_place(place, _segments.has_segment(place), "segment")
	if not problem:
		problem = WorldLimits.problem_of_speed(speed)
	if not problem:
		_segments.belts[place] = speed
		_change_contents()
	return problem


## The velocity of the surface of a segment at a point of it now, in px/s: its motion and its belt.
func surface_velocity(place: int, point: Vec2) -> Vec2:
	_segments.go_to(time, _time_low)
	return _segments.velocity_at(place, point).plus(_segments.belt_velocity(place))


## Takes copies of these balls in place of the old ones. The time goes on. A ball that overlaps a
## segment at its start is not pushed out.
func set_balls(new_balls: Array[Ball]) -> String:
	for new_ball in new_balls:
		var problem := new_ball.problem(LARGEST)
		if problem:
			return problem
	_is_there.fill(0)
	_resize_places(new_balls.size())
	for index in new_balls.size():
		_put_ball(index, new_balls[index])
		_spins.face(index, 0.0)
	return ""


## Adds a ball; its place is the old [method ball_count]. If it overlaps a segment at its start, it
## is not pushed out.
func add_ball(new_ball: Ball) -> String:
	var problem := new_ball.problem(LARGEST)
	if not problem:
		_resize_places(ball_count() + 1)
		_put_ball(ball_count() - 1, new_ball)
		_spins.face(ball_count() - 1, 0.0)
	return problem


## Puts another ball in the place of one: elsewhere, faster, larger.
func change_ball(index: int, new_ball: Ball) -> String:
	var problem := WorldLimits.problem_of_place(index, has_ball(index), "ball")
	if not problem:
		problem = new_ball.problem(LARGEST)
	if not problem:
		_put_ball(index, new_ball)
		_push_out(index, {})
	return problem


## Removes the ball at that place, which stays empty: the others keep their places.
func remove_ball(index: int) -> String:
	var problem := WorldLimits.problem_of_place(index, has_ball(index), "ball")
	if not problem:
		_halt(index)
		_is_there[index] = 0
		_support[index] = NOTHING
		_change()
	return problem


## Lets [param seconds] pass, 0 or more. Where there are more impacts than
## [member most_impacts_per_second] it returns a sentence, and the world stays at that moment.
func advance(seconds: float) -> String:
	# Kahan's sum: what the time loses by rounding is made up for by the next step.
	var step := seconds + _time_low
	var target := time + step
	# Nothing happens until then: most frames end here, so this is tested first.
	if target < _quiet_until:
		if seconds >= 0.0:
			_time_low = step - (target - time)
			time = target
			return ""
	return _advance_through_events(seconds)


## Lets time pass until [param target], in seconds since the start, which must not lie in the past.
func advance_to(target: float) -> String:
	if target < _quiet_until and target >= time:
		time = target
		_time_low = 0.0
		return ""
	return _advance_to_event(target)


## When something happens next, in seconds; INF if nothing ever does. That may be an impact, or only
## that a ball has to look for others again.
func next_event_time() -> float:
	if _has_changed:
		_begin_anew()
	return _queue.first_time


## Lets time pass until the next impact, rest or sliding off has happened. Where there is none, or
## more than [member most_impacts_per_second], it says so.
func advance_to_next_event() -> String:
	var before := _log.events.size()
	var kept := keeps_events
	keeps_events = true
	var problem := ""
	while _log.events.size() == before and not problem:
		if next_event_time() == INF or _event_time.count(INF) == ball_count():
			problem = "Nothing happens any more after %s s." % time
		else:
			problem = _advance_to(_queue.first_time, _queue.first_low)
	keeps_events = kept
	if not kept:
		_log.events.resize(before)
	return problem


## Everything that moves, as it is now.
func snapshot() -> WorldSnapshot:
	if _has_changed:
		_begin_anew()
	var kept := WorldSnapshot.new()
	kept.time = time
	kept.time_low = _time_low
	kept.impacts = impacts
	kept.contents = _contents
	kept.count_from = _count_from
	kept.counted_impacts = _counted_impacts
	kept.uses_cells = _uses_cells
	kept.cell_size = _cells.size
	kept.cell_columns = _cells.columns
	kept.keep(_all_arrays())
	kept.slides = _rolls.slides.duplicate()
	return kept


## Puts back what [method snapshot] has kept, to the last bit. Segments, walls, gravity, bounciness
## and friction must be those of that time: else a sentence says so.
func restore(kept: WorldSnapshot) -> String:
	if kept.contents != _contents:
		return "The snapshot of %s s was taken among other segments, walls or pulls." % kept.time
	_has_changed = false
	time = kept.time
	_time_low = kept.time_low
	impacts = kept.impacts
	_uses_cells = kept.uses_cells
	_cells.take_layout(kept.cell_size, kept.cell_columns)
	kept.put_into(_all_arrays())
	_rolls.slides = kept.slides.duplicate()
	_places.resize(2 * ball_count())
	_queue.resize(ball_count())
	_balls_there = _is_there.count(1)
	_is_alone = _balls_there == 1 and _segments.size() == 0 and _takes_short_ways
	_count_again()
	_count_from = kept.count_from
	_counted_impacts = kept.counted_impacts
	return ""


# After a change of balls: all is predicted anew before time passes.
func _change() -> void:
	_has_changed = true
	_segments.go_to(time, _time_low)
	_count_again()


# After a change of segments, walls, gravity, bounciness or friction.
func _change_contents() -> void:
	_contents += 1
	_segments.corners = []
	if _has_walls:
		_segments.corners = [Vec2.new(_left_x, _top_y), Vec2.new(_right_x, _bottom_y)]
	_change()


func _resize_places(count: int) -> void:
	var old := ball_count()
	for numbers: PackedFloat64Array in _float_arrays():
		numbers.resize(count)
	for numbers: PackedInt32Array in _int_arrays():
		numbers.resize(count)
	_is_there.resize(count)
	_places.resize(2 * count)
	_rolls.resize(count)
	_piles.resize(count)
	_spins.resize(count)
	_queue.resize(count)
	for index in range(old, count):
		_is_there[index] = 0
		_support[index] = NOTHING
	_change()


func _put_ball(index: int, new_ball: Ball) -> void:
	_x[index] = new_ball.position.x
	_y[index] = new_ball.position.y
	_velocity_x[index] = new_ball.velocity.x
	_velocity_y[index] = new_ball.velocity.y
	_radius[index] = new_ball.radius
	_mass[index] = new_ball.mass
	_start[index] = time
	_start_low[index] = _time_low
	_set_free(index)
	_spins.put(index, new_ball.spin)
	_is_there[index] = 1
	_change()


func _push_out_all() -> void:
	for index: int in _balls():
		_push_out(index, {})


# A ball with a side of the segment at that place in `sides` belongs there.
func _push_out_of(place: int, sides: Dictionary[int, float] = {}) -> void:
	for index: int in _balls():
		var gap := _segments.distance_to_segment(place, position_x(index), position_y(index))
		if gap < _radius[index] or sides.has(index):
			var side: float = sides.get(index, 0.0)
			_push_out(index, {place: side})


# Pushes a ball out of what it overlaps: see Overlaps.
func _push_out(index: int, sides: Dictionary[int, float]) -> void:
	var from := position(index)
	var to := Overlaps.place_outside(from, _radius[index], _segments, sides)
	if to.x != from.x or to.y != from.y:
		_restart(index)
		_set_free(index)
		_x[index] = to.x
		_y[index] = to.y
		if to.distance_to(from) > _radius[index]:
			# What was far away may be in the way now.
			_push_out(index, {})


# By their places.
func _balls() -> Dictionary[int, Ball]:
	var found: Dictionary[int, Ball] = {}
	for index in ball_count():
		if _is_there[index] == 1:
			found[index] = ball(index)
	return found


# Apart from [method advance], because a function with fewer variables is called faster.
func _advance_through_events(seconds: float) -> String:
	if not (seconds >= 0.0 and seconds <= LARGEST):
		return "The world can advance by 0 to 1e15 s, not by %s." % seconds
	if _has_changed:
		_begin_anew()
	var step := seconds + _time_low
	var target := time + step
	return _advance_to(target, step - (target - time))


# Where an event comes first, or the flight of a lone ball is not noted.
func _go_to_moment(target: float) -> void:
	if target < _quiet_until and target >= time:
		time = target
		_time_low = 0.0
	else:
		var problem := _advance_to_event(target)
		if problem:
			Refusal.push(problem)
	if _x.size() == 1 and _pull_x[0] == 0.0 and _pull_y[0] == 0.0:
		_note_lone_flight()
	else:
		_write_places(_places)


func _advance_to_event(target: float) -> String:
	if not (target >= time and target <= LARGEST):
		return WorldLimits.problem_of_target(time, target)
	if _has_changed:
		_begin_anew()
	return _advance_to(target, 0.0)


# Lets all events happen until this time. "" or a sentence, where there are too many impacts: then
# the world stays at that moment.
func _advance_to(target: float, low: float) -> String:
	var queue := _queue
	while queue.first_time <= target:
		# An event within the last place of the target is still to come: if it happened now, a fast
		# ball would be seen beyond what it bounces off.
		if queue.first_time == target and queue.first_low > low:
			break
		time = queue.first_time
		_time_low = queue.first_low
		var index := queue.first
		if _moves:
			_segments.go_to(time, _time_low)
		if _is_alone and not keeps_events and _event_kind[index] == TOUCH:
			_bounce_between_walls(index, target, low)
		else:
			_happen(index)
		if impacts - _counted_impacts > most_impacts_per_second:
			var problem := _problem_of_count()
			if problem:
				return problem
	time = target
	_time_low = low
	_quiet_until = queue.first_time
	return ""


# A new second begins where the old one is over; within one there are too many impacts.
func _problem_of_count() -> String:
	if time >= _count_from + 1.0:
		_count_again()
		return ""
	return WorldLimits.problem_of_count(most_impacts_per_second, time)


func _count_again() -> void:
	_quiet_until = -INF
	_lone_until = -INF
	_count_from = time
	_counted_impacts = impacts


# All flights begin now, from places and velocities alone, as in a world that is built now.
func _begin_anew() -> void:
	_has_changed = false
	_take_settings()
	_count_again()
	for index in ball_count():
		if _is_there[index] == 1:
			_restart(index)
			_set_free(index)
			_last_meeting[index] = -INF
			_piles.forget(index, time)
			_lasting_speed[index] = NAN
	_lay_out_cells()
	_is_alone = _balls_there == 1 and _segments.size() == 0 and _takes_short_ways
	for index in ball_count():
		_set_event(index, INF, 0.0, LOOK_AGAIN, NOTHING)
	for index in ball_count():
		if _is_there[index] == 1:
			_forecast(index)
