class_name FrictionImpact
extends RefCounted
## The first impact of a spinning ball in straight flight with a segment, with friction, and how the
## ball goes on. The segment may move or turn. Read [member hit] first: without a hit, only
## [member velocity] and [member spin] have a meaning, and are those that the ball has.

## Whether the ball hits.
var hit := false
## Seconds until the impact; 0 where the ball touches or overlaps already and approaches.
var time := 0.0
## The ball's centre at that moment, in pixels.
var position: Vec2
## From the segment to the ball's centre; length 1.
var normal: Vec2
## Which part of the segment is touched.
var feature := Impact.Feature.LINE
## Whether the surfaces slip or stick.
var regime := Friction.Regime.NONE
## The ball's velocity after the impact, in pixels per second.
var velocity: Vec2
## The ball's spin after the impact, in radians per second.
var spin := 0.0


## The impact with a segment that rests, or moves with [param segment_velocity]: seen from the
## segment, it rests and the ball flies with the difference. [param bounciness] C is 0..1,
## [param friction] µ is 0 or more. What cannot be used is an error.
static func with_segment(
	ball: Ball,
	segment: LineSegment,
	bounciness: float,
	friction: float,
	segment_velocity := Vec2.zero()
) -> FrictionImpact:
	var impact := FrictionImpact.new()
	impact._keep(ball)
	var moving := TurningSegment.new(segment, segment.start, 0.0, segment_velocity)
	if not _is_usable(ball, moving, bounciness, friction):
		return impact
	var relative := ball.velocity.minus(segment_velocity)
	var way := ball.position.distance_to(segment.start) + segment.length() + ball.radius
	var problem := Friction.problem_of_sizes(way, relative.length())
	if problem:
		push_error("FrictionImpact: " + problem)
		return impact
	var finder := StraightImpactFinder.new()
	impact.hit = finder.with_segment(
		ball.position.x,
		ball.position.y,
		relative.x,
		relative.y,
		ball.radius,
		segment.start.x,
		segment.start.y,
		segment.end.x,
		segment.end.y
	)
	if impact.hit:
		impact.feature = finder.feature
		var normal_then := Vec2.new(finder.normal_x, finder.normal_y)
		impact._bounce(ball, finder.time, normal_then, bounciness, friction, segment_velocity)
	return impact


## The same by the steps of the lecture, within [param longest] seconds. The formula for an end of
## the segment, (-b - sqrt(b² - 4 a c)) / 2a, loses its digits in a grazing impact and far away:
## then it errs in the time, or does not see the impact. The normal and the velocity inherit that.
## Where a square is too large for a double, no number comes out at all.
static func with_segment_by_the_slide(
	ball: Ball,
	segment: LineSegment,
	bounciness: float,
	friction: float,
	longest: float,
	segment_velocity := Vec2.zero()
) -> FrictionImpact:
	var impact := FrictionImpact.new()
	impact._keep(ball)
	var moving := TurningSegment.new(segment, segment.start, 0.0, segment_velocity)
	if not _is_usable(ball, moving, bounciness, friction):
		return impact
	var motion := ball.velocity.minus(segment_velocity).scaled(longest)
	var found := SegmentImpact.with_segment(ball.position, motion, ball.radius, segment)
	impact.hit = found.hit
	if found.hit:
		impact.feature = found.feature
		var seconds := found.fraction * longest
		impact._bounce(ball, seconds, found.normal, bounciness, friction, segment_velocity)
	return impact


## The impact with a segment that turns, within [param longest] seconds: at that moment the touched
## point moves as a wall does.
static func with_turning(
	ball: Ball, turning: TurningSegment, bounciness: float, friction: float, longest: float
) -> FrictionImpact:
	var impact := FrictionImpact.new()
	impact._keep(ball)
	if not _is_usable(ball, turning, bounciness, friction):
		return impact
	var finder := TurningImpactFinder.new()
	impact.hit = finder.find(ball, turning, longest)
	if impact.hit:
		impact.feature = finder.feature
		var touched := turning.velocity_at(finder.arm)
		impact._bounce(ball, finder.time, finder.normal, bounciness, friction, touched)
	return impact


func _keep(ball: Ball) -> void:
	velocity = ball.velocity.copy()
	spin = ball.spin


func _bounce(
	ball: Ball,
	at_time: float,
	with_normal: Vec2,
	bounciness: float,
	friction: float,
	wall_velocity: Vec2
) -> void:
	time = at_time
	normal = with_normal
	position = ball.position.plus(ball.velocity.scaled(time))
	var bouncing := ball.copy()
	regime = FrictionBounce.bounce(bouncing, normal, bounciness, friction, wall_velocity)
	_keep(bouncing)


static func _is_usable(
	ball: Ball, segment: TurningSegment, bounciness: float, friction: float
) -> bool:
	for problem: String in [
		ball.problem(Friction.LARGEST),
		segment.problem(Friction.LARGEST),
		FrictionBounce.problem_of_surface(bounciness, friction),
	]:
		if problem:
			push_error("FrictionImpact: " + problem)
			return false
	return true
