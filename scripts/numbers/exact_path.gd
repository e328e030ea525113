class_name ExactPath
extends RefCounted
## The path of one elastic ball in straight flight among two-sided segments with round caps,
## followed from impact to impact with about 100 bits: the exact answer that other methods are
## compared with.
##
## All arguments are taken as exact. Among obstacles an error is multiplied at every bounce: doubles
## lose the path after about 20 bounces, and twice the digits keep it twice as long. Slow: one to
## two milliseconds a bounce.

## The distance of a far segment is taken smaller by this fraction of the coordinates: much more
## than the rounding of doubles, and much less than matters for speed.
const _MARGIN := 1e-9

## The flights up to [member time]; each but the first begins with a bounce.
var flights: Array[ExactFlight] = []
## The time up to which the path has been followed, in seconds.
var time := 0.0

var _radius: float
var _segments: Array[LineSegment] = []
# The impact that ends the last flight, and the index of its segment.
var _next: ExactImpact
var _next_index: int


## Starts again at time 0 with copies of the ball and the segments. Returns "", or one sentence
## about what cannot be used; then nothing has changed.
func start(ball: Ball, segments: Array[LineSegment]) -> String:
	var problem := _problem_of(ball, segments)
	if problem:
		return problem
	_radius = ball.radius
	_segments.assign(segments.map(func(segment: LineSegment) -> LineSegment: return segment.copy()))
	flights.clear()
	time = 0.0
	var place := ExactVector.from_vec2(ball.position)
	var speed := ExactVector.from_vec2(ball.velocity)
	_begin_flight(ExactFlight.new(DoubleDouble.from_float(0.0), place, speed, -1))
	return ""


## Follows the path to the time [param until], in seconds since the start. Returns "", or one
## sentence, and then [member time] does not change: for a time that is past or not finite, before
## [method start], and after more than [param most_bounces] bounces, such as those between two
## segments that both overlap the ball.
func advance_to(until: float, most_bounces: int = 100000) -> String:
	if not (until >= time and is_finite(until)):
		return "The path goes on from %s s to a finite time, not to %s." % [time, until]
	if flights.is_empty():
		return "The path has no start yet: 0 balls are there, 1 is needed."
	var most := flights.size() + most_bounces
	while _next.hit and not DoubleDouble.from_float(until).is_less_than(_end_of_flight()):
		if flights.size() == most:
			return "There are more than %d bounces before %s s." % [most_bounces, until]
		_bounce()
	time = until
	return ""


## The number of bounces up to [member time].
func bounces() -> int:
	return maxi(flights.size() - 1, 0)


## The centre at [member time], rounded to doubles.
func position() -> Vec2:
	return exact_position().to_vec2()


## The velocity at [member time], in pixels per second, rounded to doubles.
func velocity() -> Vec2:
	return flights[-1].velocity.to_vec2()


## The centre at [member time] with all its digits.
func exact_position() -> ExactVector:
	return flights[-1].position_at(time)


## The centre at any time from 0 to [member time], rounded to doubles.
func position_at(at_time: float) -> Vec2:
	return flight_at(at_time).position_at(at_time).to_vec2()


## The flight at [param at_time]; at the time of a bounce the flight that begins with it.
func flight_at(at_time: float) -> ExactFlight:
	var first := 0
	var last := flights.size() - 1
	while first < last:
		var middle := (first + last + 1) >> 1
		if flights[middle].start.high <= at_time:
			first = middle
		else:
			last = middle - 1
	return flights[first]


func _bounce() -> void:
	var flight := flights[-1]
	var position_then := flight.after(_next.time)
	var velocity_then := flight.velocity.reflected(_next.normal)
	_begin_flight(ExactFlight.new(_end_of_flight(), position_then, velocity_then, _next_index))


func _end_of_flight() -> DoubleDouble:
	return flights[-1].start.plus(_next.time)


func _begin_flight(flight: ExactFlight) -> void:
	flights.append(flight)
	_next = ExactImpact.new()
	for index in _segments.size():
		# A segment is convex: a ball that has bounced off it does not come back in straight flight.
		if index != flight.segment_index and not _is_surely_later(flight, _segments[index]):
			_keep_if_earlier(flight, index)


func _keep_if_earlier(flight: ExactFlight, index: int) -> void:
	var impact := ExactImpact.with_segment(
		flight.position, flight.velocity, _radius, _segments[index]
	)
	if impact.hit and not (_next.hit and not impact.time.is_less_than(_next.time)):
		_next = impact
		_next_index = index


# Avoids the slow arithmetic for most segments. Doubles give the least time that the ball needs to
# come within reach of the segment's infinite line, and of its extent along that line.
func _is_surely_later(flight: ExactFlight, segment: LineSegment) -> bool:
	var latest := _next.time.high if _next.hit else INF
	var velocity_now := flight.velocity.to_vec2()
	var difference := flight.position.to_vec2().minus(segment.start)
	var along := segment.along().normalized()
	var across := along.normal()
	var size := difference.length() + segment.length() + segment.start.length() + _radius
	var reach := _radius + _MARGIN * size
	var distance := difference.dot(across)
	if _least_time(absf(distance) - reach, -signf(distance) * velocity_now.dot(across)) >= latest:
		return true
	var middle := segment.length() / 2.0
	var beside := difference.dot(along) - middle
	var way := absf(beside) - middle - reach
	return _least_time(way, -signf(beside) * velocity_now.dot(along)) >= latest


# The least time for a way at a speed of approach, to which the rounding error of a double is added.
func _least_time(way: float, approach: float) -> float:
	var most := approach + _MARGIN * flights[-1].velocity.to_vec2().length()
	if way <= 0.0:
		return 0.0
	return way / most if most > 0.0 else INF


static func _problem_of(ball: Ball, segments: Array[LineSegment]) -> String:
	for segment in segments:
		if segment.problem():
			return segment.problem()
	return ball.problem()
