class_name TurningImpactFinder
extends RefCounted
## The first impact of a ball, in straight flight or under gravity, with a segment that turns about
## a pivot.
##
## There is no formula for the time. Seen from the segment the ball flies on a spiral, and the gap
## between both is looked at again and again. The gap cannot bend towards 0 by more than a known
## bound, in px/s²: 2 |turn| |V| + turn² d + |g|, with the velocity V, the distance d from the pivot
## and the gravity g. Under gravity V grows, so no step is longer than V takes to double, or so.
## So with the gap and its growth at one moment, a parabola lies below the gap from then on. The
## next look is where that parabola comes down to 0: never behind an impact, and near one the steps
## are those of Newton's method.
## [br][br]
## A ball that overlaps already has its impact at the first moment at which it approaches. After a
## call that returned false, the members have no meaning.

## No number may be larger than this, in pixels, seconds and radians: else a square or a product in
## the search could be too large for a double.
const LARGEST := 1e70

## Seconds until the impact.
var time := 0.0
## The contact normal at that moment, towards the ball's centre; length 1.
var normal: Vec2
## The vector from the pivot to the point that is touched, at that moment, in pixels.
var arm: Vec2
## Which part of the segment is touched.
var feature := Impact.Feature.LINE
## After a call that returned false: whether the ball never meets the segment, however long it
## flies.
var is_gone := false

# All from the pivot: the ball's centre and its velocity, and the segment, at the time 0.
var _start: Vec2
var _velocity: Vec2
var _pull: Vec2
var _wall: LineSegment
var _turn := 0.0
var _radius := 0.0
# At the time of the last look: pixels between the ball and the segment, and px/s.
var _gap := 0.0
var _growth := 0.0


## Whether [param ball] meets [param turning] within [param longest] seconds, which must be finite,
## under the constant acceleration [param pull] in px/s². What cannot be used is an error.
func find(ball: Ball, turning: TurningSegment, longest: float, pull: Vec2 = Vec2.zero()) -> bool:
	is_gone = false
	if not _can_find(ball, turning, longest):
		return false
	_set_up(ball, turning)
	_pull = pull.copy()
	var reach := turning.reach() + _radius
	var nearest := _wall.closest_point(Vec2.zero()).length() - _radius
	var strength := _pull.length()
	if _velocity.length() == 0.0 and strength == 0.0 and _turn != 0.0:
		longest = minf(longest, TAU / absf(_turn))
		is_gone = true
	time = 0.0
	while time <= longest:
		_look()
		var speed := _velocity_now().length()
		var longest_step := INF
		if strength > 0.0:
			longest_step = (speed + absf(_turn) * reach + sqrt(strength * _radius)) / strength
			speed += strength * longest_step
		var bend := absf(_turn) * (2.0 * speed + absf(_turn) * reach) + strength
		var step := minf(FreeFlight.time_to_fall(_gap, _growth, -bend), longest_step)
		step = maxf(step, _time_beside_ring(nearest, reach, strength))
		if time + step == time:
			_turn_back()
			return normal.length() > 0.0
		time += step
		if _leaves_for_good(reach):
			is_gone = true
			return false
	return false


## The same as a game looks for it, once a frame of [param frame] seconds: if the ball overlaps, the
## moment is found by halving the frame. What begins and ends between two looks is not seen: a fast
## ball, or the end of a fast paddle, passes through.
func find_by_frames(ball: Ball, turning: TurningSegment, longest: float, frame: float) -> bool:
	if not (frame > 0.0 and frame < INF):
		push_error("TurningImpactFinder: A frame must take more than 0 s, not %s s." % frame)
		return false
	if not _can_find(ball, turning, longest):
		return false
	_set_up(ball, turning)
	time = 0.0
	while time < longest:
		var before := time
		time = minf(time + frame, longest)
		_look()
		if _gap <= 0.0:
			_halve(before, time)
			_turn_back()
			return true
	return false


func _halve(left: float, right: float) -> void:
	while true:
		time = left + 0.5 * (right - left)
		if time <= left or time >= right:
			return
		_look()
		if _gap <= 0.0:
			right = time
		else:
			left = time


static func _can_find(ball: Ball, turning: TurningSegment, longest: float) -> bool:
	var problem := ball.problem(LARGEST)
	if not problem:
		problem = turning.problem(LARGEST)
	if not problem and not (longest >= 0.0 and is_finite(longest)):
		problem = "The search must take 0 s or more and end, not take %s s." % longest
	if problem:
		push_error("TurningImpactFinder: " + problem)
	return problem == ""


func _set_up(ball: Ball, turning: TurningSegment) -> void:
	_start = ball.position.minus(turning.pivot)
	_velocity = ball.velocity.minus(turning.velocity)
	var segment := turning.segment
	_wall = LineSegment.new(segment.start.minus(turning.pivot), segment.end.minus(turning.pivot))
	_turn = turning.turn
	_radius = ball.radius
	_pull = Vec2.zero()


# Whether the ball is beyond what the segment reaches, and gets farther away from the pivot for
# ever.
func _leaves_for_good(reach: float) -> bool:
	var way := _way()
	var velocity := _velocity_now()
	if way.length() <= reach or way.dot(velocity) < 0.0:
		return false
	return way.dot(_pull) >= 0.0 and velocity.dot(_pull) >= 0.0


# For how long the ball surely is not within the ring in which it can meet the segment, whose inner
# and outer radius are given; 0 where it is there now.
func _time_beside_ring(inner: float, outer: float, strength: float) -> float:
	var distance := _way().length()
	var free := maxf(inner - distance, distance - outer)
	if free <= 0.0:
		return 0.0
	var speed := _velocity_now().length()
	if strength == 0.0:
		return free / speed
	return 2.0 * free / (speed + sqrt(speed * speed + 2.0 * strength * free))


# From the pivot to the ball's centre.
func _way() -> Vec2:
	return _start.plus(_velocity.plus(_pull.scaled(0.5 * time)).scaled(time))


func _velocity_now() -> Vec2:
	return _velocity.plus(_pull.scaled(time))


# Looks at the ball from the turning segment, for which the segment rests and the ball turns back.
func _look() -> void:
	var angle := _turn * time
	var way := _way()
	way.rotate_radians(-angle)
	var velocity := _velocity_now()
	velocity.rotate_radians(-angle)
	velocity.add(Vec2.new(way.y, -way.x).scaled(_turn))
	var share := _wall.share_of(way)
	if share >= 0.0 and share <= 1.0:
		_look_at_line(way, velocity)
		arm = _wall.start.lerped(_wall.end, share)
		return
	feature = Impact.Feature.START if share < 0.0 else Impact.Feature.END
	arm = (_wall.start if share < 0.0 else _wall.end).copy()
	var away := way.minus(arm)
	normal = away.normalized()
	_gap = away.length() - _radius
	_growth = velocity.dot(normal)


func _look_at_line(way: Vec2, velocity: Vec2) -> void:
	feature = Impact.Feature.LINE
	normal = _wall.normal()
	var distance := LineDistance.signed_distance(way, _wall)
	# A centre on the line itself is on the side from which it comes.
	if distance < 0.0 or (distance == 0.0 and velocity.dot(normal) > 0.0):
		normal.scale(-1.0)
	_gap = absf(distance) - _radius
	_growth = velocity.dot(normal)


# Turns what the last look has found as the segment is turned.
func _turn_back() -> void:
	normal.rotate_radians(_turn * time)
	arm.rotate_radians(_turn * time)
