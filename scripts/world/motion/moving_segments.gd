class_name MovingSegments
extends SegmentGrid
## Segments of which some move, each by its [MotionPieces]. The others are in the grid, as ever;
## those that move are tried one by one, and are where they are at the time of the last
## [method go_to].
##
## Seen from a segment with a constant velocity a ball flies as ever, with the difference of both
## velocities. So each piece of a motion is tried for itself, with the flight as it is when the
## piece begins.

# A ball that will be crushed within this time, in seconds, is held when its bounces get too short.
const _SOON := 0.1
# After so many pieces of a motion the search ends, and the ball has to look again.
const _MOST_PIECES := 64
# The same for a segment that turns, in seconds.
const _LONGEST_LOOK := 8.0

var _movers: Dictionary[int, SegmentMover] = {}
var _now := 0.0
var _now_low := 0.0
# The velocity of the frame from which the segments are seen, in px/s.
var _frame_x := 0.0
var _frame_y := 0.0
var _turning := TurningImpactFinder.new()
# Seconds until a search that was given up has to go on; INF where none was.
var _look_again := INF


## Takes all segments of another list, which stays as it is.
func take_from(others: SegmentScan) -> void:
	for place in others.size():
		put(place, others.segment(place))
		if not others.has_segment(place):
			remove(place)
	belts = others.belts


## Lets the segment at that place move.
func move(place: int, mover: SegmentMover) -> void:
	_movers[place] = mover
	# It is not in the grid.
	_is_there[place] = 0
	_is_stale = true


## See [method SegmentList.put]. A motion of the old segment is over.
func put(place: int, new_segment: LineSegment) -> void:
	super.put(place, new_segment)
	_movers.erase(place)


## See [method SegmentList.remove].
func remove(place: int) -> void:
	super.remove(place)
	_movers.erase(place)
	_is_stale = true


## See [method SegmentList.has_segment].
func has_segment(place: int) -> bool:
	return super.has_segment(place) or _movers.has(place)


## See [method SegmentScan.has_motion].
func has_motion() -> bool:
	return super.has_motion() or not _movers.is_empty()


## See [method SegmentScan.go_to].
func go_to(now: float, low: float) -> void:
	_now = now
	_now_low = low
	for place: int in _movers:
		var mover := _movers[place]
		mover.go_to(now, low)
		_lay(place, mover.segment_now())


## See [method SegmentScan.see_from].
func see_from(place: int) -> void:
	_frame_x = segment_velocity_x(place)
	_frame_y = segment_velocity_y(place)


## See [method SegmentScan.segment_velocity_x].
func segment_velocity_x(place: int) -> float:
	return _movers[place].velocity.x if _is_steady(place) else 0.0


## See [method SegmentScan.segment_velocity_y].
func segment_velocity_y(place: int) -> float:
	return _movers[place].velocity.y if _is_steady(place) else 0.0


## See [method SegmentScan.velocity_at].
func velocity_at(place: int, point: Vec2) -> Vec2:
	return _movers[place].velocity_at(point) if _movers.has(place) else Vec2.zero()


## See [method SegmentScan.turn_of].
func turn_of(place: int) -> float:
	return _movers[place].motion.turn if _movers.has(place) else 0.0


## See [method SegmentScan.seconds_left].
func seconds_left(place: int) -> float:
	return _movers[place].seconds_left() if _movers.has(place) else INF


## The unit normal of a segment that only moves along is that which it was given: its ends are
## rounded anew each time.
func normal_x(place: int) -> float:
	if _is_steady(place):
		var given := _movers[place].given
		return (given.start.y - given.end.y) / _length[place]
	return super.normal_x(place)


## See [method normal_x].
func normal_y(place: int) -> float:
	if _is_steady(place):
		var given := _movers[place].given
		return (given.end.x - given.start.x) / _length[place]
	return super.normal_y(place)


## See [method SegmentList.places_within].
func places_within(x: float, y: float, reach: float) -> PackedInt32Array:
	var places := super.places_within(x, y, reach)
	for place: int in _movers:
		if distance_to_segment(place, x, y) <= reach:
			places.append(place)
	places.sort()
	return places


## The places of the segments that a ball at this point might touch and that rest in the frame from
## which they are seen, in their order.
func places_near(x: float, y: float, ball_radius: float) -> PackedInt32Array:
	var places: PackedInt32Array = []
	if _frame_x == 0.0 and _frame_y == 0.0:
		places = super.places_near(x, y, ball_radius)
	for place: int in _movers:
		if _rests_in(place, _frame_x, _frame_y):
			places.append(place)
	places.sort()
	return places


## See [method SegmentScan.first_impact].
func first_impact(
	x: float,
	y: float,
	velocity_x_now: float,
	velocity_y_now: float,
	radius: float,
	horizon: float,
	skipped: int = -1
) -> bool:
	super.first_impact(x, y, velocity_x_now, velocity_y_now, radius, horizon, skipped)
	_look_again = INF
	for place: int in _movers:
		_try_pieces(place, false)
	return _ends_search()


## See [method SegmentScan.first_accelerated_impact].
func first_accelerated_impact(
	x: float,
	y: float,
	velocity_x_now: float,
	velocity_y_now: float,
	pull_x: float,
	pull_y: float,
	radius: float,
	horizon: float,
	skipped: int = -1
) -> bool:
	var contact := _contact
	var frame_x := segment_velocity_x(contact_place)
	var frame_y := segment_velocity_y(contact_place)
	# What a ball touches says nothing of segments that move otherwise.
	if frame_x != 0.0 or frame_y != 0.0:
		_contact = Contact.NONE
	super.first_accelerated_impact(
		x, y, velocity_x_now, velocity_y_now, pull_x, pull_y, radius, horizon, skipped
	)
	_look_again = INF
	for place: int in _movers:
		_contact = contact if _rests_in(place, frame_x, frame_y) else Contact.NONE
		_try_pieces(place, true)
		_end_contact()
	return _ends_search()


## See [method SegmentScan.squeeze_of].
func squeeze_of(of_ball: Ball, is_hurried: bool) -> Squeeze:
	var at := of_ball.position
	if not has_motion_near(at.x, at.y, of_ball.radius):
		return Squeeze.NONE
	var around := super.places_near(at.x, at.y, of_ball.radius)
	around.append_array(PackedInt32Array(_movers.keys()))
	var slack := TOUCH + ROUNDING * (absf(at.x) + absf(at.y))
	var lasts := _SOON
	var squeeze := BallSqueeze.new(of_ball)
	for place in around:
		var point := nearest_point(place, at.x, at.y)
		squeeze.add(point, velocity_at(place, point))
		lasts = minf(lasts, seconds_left(place))
		slack = maxf(slack, TOUCH + ROUNDING * _way_of(place))
	for point in wall_points(at.x, at.y):
		squeeze.add(point, Vec2.zero())
	squeeze.find(of_ball.radius if is_hurried else slack, slack)
	crush_seconds = squeeze.seconds
	crush_velocity = squeeze.velocity
	if crush_seconds == 0.0 or crush_seconds < lasts:
		return Squeeze.CRUSHED
	return Squeeze.SHAKEN if is_hurried else Squeeze.NONE


## See [method SegmentScan.has_motion_near].
func has_motion_near(x: float, y: float, radius: float) -> bool:
	for place: int in _movers:
		if distance_to_segment(place, x, y) <= radius + _BELT_GAP:
			return true
	return super.has_motion_near(x, y, radius)


## See [method SegmentScan.pressure_at].
func pressure_at(place: int, centre: Vec2, velocity: Vec2, normal: Vec2) -> float:
	if turn_of(place) == 0.0:
		return 0.0
	var turning := _movers[place].turning()
	var arm := centre.minus(turning.pivot)
	# In the frame that turns: the centrifugal and the Coriolis acceleration.
	var seen := velocity.minus(turning.velocity_at(arm))
	var outwards := arm.scaled(turning.turn * turning.turn)
	var aside := Vec2.new(seen.y, -seen.x).scaled(2.0 * turning.turn)
	return -normal.dot(outwards.plus(aside))


# How far a segment has come in its motion, in pixels: as far as rounding counts.
func _way_of(place: int) -> float:
	if not _movers.has(place):
		return 0.0
	return _movers[place].velocity.length() * _movers[place].seconds


# Whether something is found: an impact, or that the search has to go on at a later time.
func _ends_search() -> bool:
	if _look_again < time:
		time = _look_again
		index = -1
		return true
	return index >= 0


# Tries one piece of the motion after the other, until the flight is over or there are too many.
func _try_pieces(place: int, is_pulled: bool) -> void:
	var mover := _movers[place]
	if mover.motion.turn != 0.0:
		_try_turning(place, is_pulled)
		return
	var flight: PackedFloat64Array = [_x, _y, _velocity_x, _velocity_y]
	var skipped := _skipped
	var begin := 0.0
	var piece := mover.piece
	if mover.seconds_left() < INF:
		var clear := _time_beside(mover, is_pulled)
		piece = mover.motion.piece_at(mover.seconds + clear) if clear < INF else piece
		begin = clear if clear == INF else _begin_of(piece, mover)
	var last := piece + _MOST_PIECES
	while begin < time:
		if piece == last:
			_look_again = minf(_look_again, begin)
			break
		if piece > mover.piece:
			_lay(place, mover.segment_after(mover.motion.way_of(piece)))
			_skipped = -1
			_end_contact()
		var end := maxf(mover.motion.piece_end(piece) - mover.seconds, begin)
		_begin_flight(flight, begin, mover.motion.velocity_of(piece), is_pulled)
		if _is_met(place, begin, end, is_pulled):
			break
		piece += 1
		begin = _begin_of(piece, mover)
	_lay(place, mover.segment_now())
	_skipped = skipped
	_x = flight[0]
	_y = flight[1]
	_velocity_x = flight[2]
	_velocity_y = flight[3]


# The same for a segment that turns.
func _try_turning(place: int, is_pulled: bool) -> void:
	var mover := _movers[place]
	var longest := minf(time, _LONGEST_LOOK)
	var flying := Ball.new(Vec2.new(_x, _y), _radius, Vec2.new(_velocity_x, _velocity_y))
	var pull := Vec2.new(_pull_x, _pull_y) if is_pulled else Vec2.zero()
	if _turning.find(flying, mover.turning(), longest, pull):
		if _turning.time < time:
			_take(place, _turning.time, _turning.feature)
	elif not _turning.is_gone and longest < time:
		_look_again = minf(_look_again, longest)


# When a piece begins, in seconds of the flight; 0 for one that lasts.
func _begin_of(piece: int, mover: SegmentMover) -> float:
	return maxf(mover.motion.piece_begin(piece) - mover.seconds, 0.0)


# For how long the ball surely is beside all that the path of a segment covers; INF where it never
# comes there.
func _time_beside(mover: SegmentMover, is_pulled: bool) -> float:
	var away := Vec2.new(_x, _y).minus(mover.given.start.lerped(mover.given.end, 0.5))
	var reach := 0.5 * mover.given.length() + mover.motion.longest_way() + _radius
	var clear := away.length() - reach
	if clear <= 0.0:
		return 0.0
	var velocity := Vec2.new(_velocity_x, _velocity_y)
	var pull := Vec2.new(_pull_x, _pull_y) if is_pulled else Vec2.zero()
	if minf(away.dot(velocity), minf(away.dot(pull), velocity.dot(pull))) >= 0.0:
		return INF
	var speed := velocity.length()
	return 2.0 * clear / (speed + sqrt(speed * speed + 2.0 * pull.length() * clear))


# The flight as it is after so many seconds, seen from what moves with this velocity.
func _begin_flight(
	flight: PackedFloat64Array, seconds: float, frame: Vec2, is_pulled: bool
) -> void:
	var pull_x := _pull_x if is_pulled else 0.0
	var pull_y := _pull_y if is_pulled else 0.0
	_x = flight[0] + (flight[2] + 0.5 * pull_x * seconds) * seconds
	_y = flight[1] + (flight[3] + 0.5 * pull_y * seconds) * seconds
	_velocity_x = flight[2] + pull_x * seconds - frame.x
	_velocity_y = flight[3] + pull_y * seconds - frame.y
	var squared_speed := _velocity_x * _velocity_x + _velocity_y * _velocity_y
	_reach_squared = 1.000001 * _radius * _radius * squared_speed
	if is_pulled:
		_ask_accelerated(pull_x, pull_y)


# Whether the ball meets the segment, which lies where it is after `begin` seconds of the flight,
# until `end` and before everything else.
func _is_met(place: int, begin: float, end: float, is_pulled: bool) -> bool:
	var best := time
	var best_index := index
	var best_feature := feature
	time = minf(best, end) - begin
	index = -1
	_is_there[place] = 1
	if is_pulled:
		_try_accelerated(place)
	else:
		_try(place)
	_is_there[place] = 0
	var is_met := index == place
	var seconds := begin + time
	var met_feature := feature
	time = best
	index = best_index
	feature = best_feature
	if is_met:
		_take(place, seconds, met_feature)
	return is_met


# Whether the segment at that place moves without turning.
func _is_steady(place: int) -> bool:
	return _movers.has(place) and _movers[place].motion.turn == 0.0


# Whether the segment at that place moves with this velocity now, and does not turn.
func _rests_in(place: int, frame_x: float, frame_y: float) -> bool:
	if not _is_steady(place):
		return false
	return segment_velocity_x(place) == frame_x and segment_velocity_y(place) == frame_y


# Puts the ends of a segment that moves where they are.
func _lay(place: int, at: LineSegment) -> void:
	_start_x[place] = at.start.x
	_start_y[place] = at.start.y
	_end_x[place] = at.end.x
	_end_y[place] = at.end.y
