class_name EndlessLineMover
extends BallMover
## The lines of the lecture's week 4: endless, with one good side. The ball moves for the whole
## frame; where it is too close to a line or behind it, it is put back and bounces.
##
## So a line acts beyond its ends, and a ball that was behind it all the time is put in front of it.


## See [method BallMover.move].
func move(ball: Ball, seconds: float, surroundings: Surroundings) -> Array[BounceRecord]:
	var bounces: Array[BounceRecord] = []
	fly(ball, seconds, surroundings.gravity)
	for line in surroundings.segments:
		if LineDistance.is_overlapping(ball, line):
			PositionReset.reset(ball, line)
			var touch := Impact.at(1.0, ball.position, line.normal(), Impact.Feature.LINE)
			bounce(ball, touch, surroundings.bounciness, bounces)
	return bounces


## A changed line puts no ball out of its way: the test in each frame does.
func pushes_out() -> bool:
	return false
