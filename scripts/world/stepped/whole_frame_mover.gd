class_name WholeFrameMover
extends BallMover
## The right way to step: the ball goes from impact to impact until the frame's time is used up.
##
## In each part of the frame gravity acts for as long as that part lasts. So no time is lost, and
## with C = 1 no energy.

## The most parts of a frame; the time that is left after them is dropped. A larger number would
## only cost time in corners that are too narrow for the ball.
const MOST_PARTS := 32


## See [method BallMover.move].
func move(ball: Ball, seconds: float, surroundings: Surroundings) -> Array[BounceRecord]:
	var bounces: Array[BounceRecord] = []
	if fly_clear(ball, seconds, surroundings):
		return bounces
	move_under(surroundings.gravity, ball, seconds, surroundings, bounces)
	return bounces


## Moves the ball under [param gravity] from impact to impact, and adds its bounces to
## [param bounces].
func move_under(
	gravity: Vec2,
	ball: Ball,
	seconds: float,
	surroundings: Surroundings,
	bounces: Array[BounceRecord]
) -> void:
	var part := FramePart.new(seconds, gravity)
	for i in MOST_PARTS:
		var motion := FreeFlight.motion(ball.velocity, part.pull, part.seconds)
		var impact := find_impact(ball, motion, surroundings, part.skipped)
		if impact.hit:
			var count := bounces.size()
			fly_to(ball, impact, part.seconds, part.pull)
			bounce(ball, impact, surroundings.bounciness, bounces)
			part.leave(ball, impact, bounces.size() > count, surroundings)
		else:
			fly(ball, part.seconds, part.pull)
			if part.lies():
				_lift(ball, surroundings)
			part.pass_by()
		if part.left <= 0.0:
			return


# A ball that slides over a joint may sink into the next line by some 1e-8 px, where this rises so
# little that rounding hides the touch.
func _lift(ball: Ball, surroundings: Surroundings) -> void:
	var push := PushOut.new(ball.position, ball.radius, Surroundings.FLUSH)
	for index in surroundings.near_segments(ball.position, Vec2.zero(), ball.radius):
		push.add_line(surroundings.segments[index])
	ball.position = push.position()


## The first impact in this part of the frame, without the segments with the indices
## [param skipped].
func find_impact(
	ball: Ball, motion: Vec2, surroundings: Surroundings, skipped: PackedInt32Array
) -> Impact:
	return surroundings.first_impact(ball, motion, skipped)
