class_name WorkshopReferenceBounce
extends RefCounted
## A right answer to the exercise about a ball among many lines, by the lab's own code.


## What the student's MyBall is, with the lab's vectors.
class MyBall:
	## See MyBall in the student's file.
	var position: Vec2
	## See MyBall in the student's file.
	var velocity: Vec2
	## See MyBall in the student's file.
	var acceleration: Vec2
	## See MyBall in the student's file.
	var radius := 10.0


## What the student's MySegment is, with the lab's vectors.
class MySegment:
	## See MySegment in the student's file.
	var start: Vec2
	## See MySegment in the student's file.
	var end: Vec2


## More bounces than this in one frame are not followed.
const MOST_BOUNCES := 20


## See exercise 10.
static func step(ball: MyBall, lines: Array, seconds: float) -> void:
	var segments: Array[LineSegment] = []
	for line: MySegment in lines:
		segments.append(LineSegment.new(line.start, line.end))
	var left := seconds
	for bounce in MOST_BOUNCES:
		var motion := FreeFlight.motion(ball.velocity, ball.acceleration, left)
		var impact := SegmentImpact.with_segments(ball.position, motion, ball.radius, segments)
		if not impact.hit:
			ball.position.add(motion)
			ball.velocity = FreeFlight.velocity_after(ball.velocity, ball.acceleration, left)
			return
		var way := motion.scaled(impact.fraction)
		var flown := left * impact.fraction
		ball.velocity = FreeFlight.velocity_at(ball.velocity, ball.acceleration, way, flown)
		ball.position = impact.position
		Bounce.apply(ball.velocity, impact.normal)
		left -= flown
