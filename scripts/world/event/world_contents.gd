class_name WorldContents
extends BallEvents
## What an [EventWorld] holds, and how it is changed while time goes on: balls, segments, walls,
## gravity, bounciness. Predictions are made anew only for what a change touches.
##
## What cannot be taken is refused: each method returns "" or one sentence with the value and what
## is allowed, and then nothing has changed.

## Coordinates, speeds, sizes, masses and gravity stay within this, in pixels, seconds and their
## quotients.
const LARGEST := 1e15

## Whether few segments near a flight are asked (true), or all; the answers are the same. To be set
## before the first segment.
var uses_grid := true:
	set = _set_uses_grid

# Impacts are counted from here on, for one second.
var _count_from := 0.0
var _counted_impacts := 0
# Until then nothing happens, as far as is known without asking.
var _quiet_until := -INF
# Counts the changes of segments, walls, gravity and bounciness.
var _contents := 0


## Balls keep inside this upright box from now on: its corners at the upper left and lower right.
func set_walls(low: Vec2, high: Vec2) -> String:
	if not (_is_usable(low) and _is_usable(high) and low.x < high.x and low.y < high.y):
		return (
			"The walls need a corner above and left of the other, within -1e15..1e15 px, not %s and %s."
			% [low, high]
		)
	_contents += 1
	_has_walls = true
	_left_x = low.x
	_top_y = low.y
	_right_x = high.x
	_bottom_y = high.y
	_begin_anew()
	return ""


## Takes the walls away.
func remove_walls() -> void:
	_contents += 1
	_has_walls = false
	_begin_anew()


## Takes this gravity from now on, in px/s^2.
func set_gravity(gravity: Vec2) -> String:
	if not _is_usable(gravity):
		return "Gravity must be within -1e15..1e15 px/s² in x and y, not %s." % gravity
	_contents += 1
	_gravity_x = gravity.x
	_gravity_y = gravity.y
	_lasting_speed.fill(NAN)
	_begin_anew()
	return ""


## Takes this bounciness C from now on, 0..1, for all that bounces.
func set_bounciness(bounciness: float) -> String:
	if not (bounciness >= 0.0 and bounciness <= 1.0):
		return "The bounciness C must be within 0..1, not %s." % bounciness
	_bounciness = bounciness
	_contents += 1
	return ""


## How many places for segments there are, with those of removed ones.
func segment_count() -> int:
	return _segments.size()


## The segment at that place.
func segment(place: int) -> LineSegment:
	return _segments.segment(place)


## Takes copies of these segments in place of the old ones.
func set_segments(new_segments: Array[LineSegment]) -> String:
	for new_segment in new_segments:
		if _problem_of_segment(new_segment):
			return _problem_of_segment(new_segment)
	_contents += 1
	_set_uses_grid(uses_grid)
	for place in new_segments.size():
		_segments.put(place, new_segments[place])
	_begin_anew()
	return ""


## Adds a segment; its place is the old [method segment_count].
func add_segment(new_segment: LineSegment) -> String:
	var problem := _problem_of_segment(new_segment)
	if not problem:
		_contents += 1
		_segments.put(_segments.size(), new_segment)
		_meet_new_segment(_segments.size() - 1)
	return problem


## Moves the segment at that place.
func move_segment(place: int, new_segment: LineSegment) -> String:
	var problem := _problem_of_place(place, _segments.has_segment(place), "segment")
	if not problem:
		problem = _problem_of_segment(new_segment)
	if not problem:
		_contents += 1
		_segments.put(place, new_segment)
		_lose_segment(place)
		_meet_new_segment(place)
	return problem


## Removes the segment at that place, which stays empty: the others keep their places.
func remove_segment(place: int) -> String:
	var problem := _problem_of_place(place, _segments.has_segment(place), "segment")
	if not problem:
		_contents += 1
		_segments.remove(place)
		_lose_segment(place)
	return problem


## Takes copies of these balls in place of the old ones. The time goes on.
func set_balls(new_balls: Array[Ball]) -> String:
	for new_ball in new_balls:
		if _problem_of_ball(new_ball):
			return _problem_of_ball(new_ball)
	for index in ball_count():
		_is_there[index] = 0
	_resize_places(new_balls.size())
	for index in new_balls.size():
		_put_ball(index, new_balls[index])
	_lay_out_cells()
	_begin_anew()
	return ""


## Adds a ball; its place is the old [method ball_count].
func add_ball(new_ball: Ball) -> String:
	var problem := _problem_of_ball(new_ball)
	if not problem:
		_resize_places(ball_count() + 1)
		_put_ball(ball_count() - 1, new_ball)
		_join(ball_count() - 1)
	return problem


## Puts another ball in the place of one: elsewhere, faster, larger.
func change_ball(index: int, new_ball: Ball) -> String:
	var problem := _problem_of_place(index, has_ball(index), "ball")
	if not problem:
		problem = _problem_of_ball(new_ball)
	if not problem:
		_release_partner(index)
		_put_ball(index, new_ball)
		_join(index)
	return problem


## Removes the ball at that place, which stays empty: the others keep their places.
func remove_ball(index: int) -> String:
	var problem := _problem_of_place(index, has_ball(index), "ball")
	if not problem:
		_release_partner(index)
		_is_there[index] = 0
		_balls_there -= 1
		if _uses_cells:
			_cells.remove(index)
			_cross_time[index] = INF
		_set_event(index, INF, 0.0, LOOK_AGAIN, NOTHING)
	return problem


func _count_again() -> void:
	_quiet_until = -INF
	_count_from = time
	_counted_impacts = impacts


func _set_uses_grid(value: bool) -> void:
	uses_grid = value
	_segments = SegmentGrid.new() if value else SegmentScan.new()


# All flights begin now, and all that is next is worked out anew.
func _begin_anew() -> void:
	_count_again()
	for index in ball_count():
		if _is_there[index] == 1:
			_restart(index)
			_set_free(index)
			_set_event(index, INF, 0.0, LOOK_AGAIN, NOTHING)
	for index in ball_count():
		if _is_there[index] == 1:
			_forecast(index)


func _resize_places(count: int) -> void:
	var old := ball_count()
	for numbers: PackedFloat64Array in _float_arrays():
		numbers.resize(count)
	for numbers: PackedInt32Array in _int_arrays():
		numbers.resize(count)
	_is_there.resize(count)
	_queue.resize(count)
	for index in range(old, count):
		_is_there[index] = 0
		_event_kind[index] = LOOK_AGAIN


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
	_last_meeting[index] = -INF
	_rolls.resize(ball_count())
	_lasting_speed[index] = NAN
	if _is_there[index] == 0:
		_is_there[index] = 1
		_balls_there += 1


# A ball that is new, or has been changed, finds its place among the others.
func _join(index: int) -> void:
	_count_again()
	if _uses_cells != (_balls_there >= _MANY_BALLS) or 2.0 * _radius[index] > _cells.size:
		_lay_out_cells()
		_begin_anew()
		return
	if _uses_cells:
		_cells.make_room(ball_count())
		_cells.remove(index)
		_cells.put(index, _x[index], _y[index])
	_set_event(index, INF, 0.0, LOOK_AGAIN, NOTHING)
	_forecast(index)


func _lay_out_cells() -> void:
	_balls_there = _is_there.count(1)
	_uses_cells = _balls_there >= _MANY_BALLS
	if _uses_cells:
		_cells.lay_out(_cell_size(), ball_count())
		for index in ball_count():
			if _is_there[index] == 1:
				_cells.put(index, position_x(index), position_y(index))


# About one ball a cell, and no cell smaller than the largest ball.
func _cell_size() -> float:
	var low := Vec2.new(INF, INF)
	var high := Vec2.new(-INF, -INF)
	var largest := 0.0
	for index in ball_count():
		if _is_there[index] == 1:
			var place := position(index)
			low.set_xy(minf(low.x, place.x), minf(low.y, place.y))
			high.set_xy(maxf(high.x, place.x), maxf(high.y, place.y))
			largest = maxf(largest, _radius[index])
	var area := (high.x - low.x) * (high.y - low.y)
	return maxf(2.0 * largest, sqrt(area / _balls_there))


# Balls whose next touch is with the segment at that place look again.
func _lose_segment(place: int) -> void:
	_count_again()
	for index in ball_count():
		if _is_there[index] == 1 and place in [_touched[index], _support[index]]:
			_release_partner(index)
			_restart(index)
			_set_free(index)
			_set_event(index, INF, 0.0, LOOK_AGAIN, NOTHING)
			_forecast(index)


# Only a ball that would meet the new segment first has anything to change.
func _meet_new_segment(place: int) -> void:
	_count_again()
	for index in ball_count():
		if _is_there[index] == 1 and _meets_first(index, place):
			_release_partner(index)
			_restart(index)
			_set_event(index, INF, 0.0, LOOK_AGAIN, NOTHING)
			_forecast(index)


func _meets_first(index: int, place: int) -> bool:
	var now := ball(index)
	var ends := _segments.segment(place)
	_accelerated.set_flight(
		now.position.x,
		now.position.y,
		now.velocity.x,
		now.velocity.y,
		_pull_x[index],
		_pull_y[index],
		now.radius
	)
	var horizon := _touch_time[index] - time
	return _accelerated.with_segment(ends.start.x, ends.start.y, ends.end.x, ends.end.y, horizon)


static func _is_usable(vector: Vec2) -> bool:
	return absf(vector.x) <= LARGEST and absf(vector.y) <= LARGEST


static func _problem_of_segment(new_segment: LineSegment) -> String:
	if new_segment.problem():
		return new_segment.problem()
	if not (_is_usable(new_segment.start) and _is_usable(new_segment.end)):
		var ends := [new_segment.start, new_segment.end]
		return "A segment's ends must be within -1e15..1e15 px, not %s and %s." % ends
	return ""


static func _problem_of_ball(new_ball: Ball) -> String:
	if new_ball.problem():
		return new_ball.problem()
	if not (_is_usable(new_ball.position) and _is_usable(new_ball.velocity)):
		var values := [new_ball.position, new_ball.velocity]
		return "A ball's position and velocity must be within -1e15..1e15, not %s and %s." % values
	if not (new_ball.radius <= LARGEST and new_ball.mass <= LARGEST):
		var sizes := [new_ball.radius, new_ball.mass]
		return "A ball's radius and mass must be at most 1e15, not %s and %s." % sizes
	return ""


static func _problem_of_place(place: int, is_taken: bool, what: String) -> String:
	return "" if is_taken else "There is no %s at the place %d." % [what, place]
