class_name Press
extends RefCounted
## An elastic ball between two parallel walls, of which one comes nearer: it becomes faster and
## faster, until it is crushed.
##
## The way is what is free for the ball: the distance of the walls less the ball's diameter. The
## ball starts at the moving wall and flies away from it. Each bounce off that wall adds twice the
## wall's speed V. Between two of those bounces the ball goes to the other wall and back while the
## moving wall comes to meet it, so h (u - V) stays the same, with the ball's speed u and the way h
## at each of these bounces: [method speed_after], [method way_after]. The walls meet at h0 / V; an
## infinite number of bounces comes before.

## The shortest way and the slowest wall that can be used, in px and px/s: with less, and with more
## than [constant LARGEST], the number of bounces could be too large for a double.
const SMALLEST := 1e-70
## The longest way and the fastest ball.
const LARGEST := 1e70

## Whether the ball is crushed. Then only [member time] has a meaning, and is when that happened.
var is_crushed := false
## Seconds since the start.
var time := 0.0
## The bounces off the moving wall so far: a whole number, too large for an int shortly before the
## end.
var bounces := 0.0
## The way that is free now, in pixels.
var way := 0.0
## How fast the ball flies, in pixels per second.
var speed := 0.0
## How far the ball is from touching the wall that rests, in pixels.
var distance := 0.0


## The ball's speed after a number of bounces off the moving wall, in px/s.
static func speed_after(bounces_so_far: float, ball_speed: float, wall_speed: float) -> float:
	return ball_speed + 2.0 * bounces_so_far * wall_speed


## The way that is free at that bounce, in px.
static func way_after(
	bounces_so_far: float, free_way: float, ball_speed: float, wall_speed: float
) -> float:
	var speed_then := speed_after(bounces_so_far, ball_speed, wall_speed)
	return free_way * (ball_speed - wall_speed) / (speed_then - wall_speed)


## The ball after [param seconds]. At the start [param free_way] h0 is free, in px; the ball has
## [param ball_speed] and the wall [param wall_speed], which is less and above 0, in px/s. What
## cannot be used is an error, and the ball stays at its start.
##
## To follow the bounces one by one would take longer and longer, and never come to the end. Here
## their number follows from the way that is free: n = (u0 - V) (h0 / h - 1) / 2V.
static func at(seconds: float, free_way: float, ball_speed: float, wall_speed: float) -> Press:
	var press := Press.new()
	press.way = free_way
	press.speed = ball_speed
	press.distance = free_way
	var problem := _problem_of(seconds, free_way, ball_speed, wall_speed)
	if problem:
		push_error("Press.at: " + problem)
		return press
	press.time = minf(seconds, free_way / wall_speed)
	press.way = free_way - wall_speed * seconds
	if press.way <= 0.0:
		press.is_crushed = true
		return press
	var ratio := (ball_speed - wall_speed) / (2.0 * wall_speed)
	press.bounces = floorf(ratio * (wall_speed * seconds / press.way))
	press.speed = speed_after(press.bounces, ball_speed, wall_speed)
	var way_then := way_after(press.bounces, free_way, ball_speed, wall_speed)
	# Since the bounce the ball has flown away, and perhaps come back already.
	var flown := (way_then - press.way) / wall_speed * press.speed
	press.distance = absf(way_then - flown)
	return press


static func _problem_of(
	seconds: float, free_way: float, ball_speed: float, wall_speed: float
) -> String:
	if not (seconds >= 0.0 and is_finite(seconds)):
		return "The time must be 0 s or more and finite, not %s s." % seconds
	var limits := [String.num_scientific(SMALLEST), String.num_scientific(LARGEST)]
	if not (free_way >= SMALLEST and free_way <= LARGEST):
		return "The free way must be within %s..%s px, not %s." % (limits + [free_way])
	if not (wall_speed >= SMALLEST and wall_speed <= LARGEST):
		return "The wall must come nearer with %s..%s px/s, not %s." % (limits + [wall_speed])
	if not (ball_speed > wall_speed and ball_speed <= LARGEST):
		var values := [wall_speed, limits[1], ball_speed]
		return "The ball must be faster than the wall's %s px/s, at most %s, not %s." % values
	return ""
