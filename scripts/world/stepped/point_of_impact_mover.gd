class_name PointOfImpactMover
extends BallMover
## Part 13 of the lecture as most people write it: the ball goes to the first point of impact and
## bounces, and the frame ends there.
##
## The rest of the frame is lost: the ball waits while gravity still acts. So each bounce makes it
## late, and a ball that flies from bounce to bounce loses energy. A ball that touches a line at the
## start of each frame does not move at all, while gravity adds to its speed. So its energy grows,
## and it shoots off when the line is taken away.


## See [method BallMover.move].
func move(ball: Ball, seconds: float, surroundings: Surroundings) -> Array[BounceRecord]:
	var bounces: Array[BounceRecord] = []
	if fly_clear(ball, seconds, surroundings):
		return bounces
	var gravity := surroundings.gravity
	var motion := FreeFlight.motion(ball.velocity, gravity, seconds)
	var impact := surroundings.first_impact(ball, motion)
	if not impact.hit:
		fly(ball, seconds, gravity)
		return bounces
	fly_to(ball, impact, seconds, gravity)
	bounce(ball, impact, surroundings.bounciness, bounces)
	ball.velocity.add(gravity.scaled(seconds * (1.0 - impact.fraction)))
	return bounces
