class_name PositionResetMover
extends BallMover
## The simple way, part 12 of the lecture: moves the ball, tests whether it overlaps a line, and
## puts it back.
##
## The ball has moved for the whole frame and is lifted back against gravity, so it gains energy. It
## passes through a line if it is beyond it at the end of the frame.


## See [method BallMover.move].
func move(ball: Ball, seconds: float, surroundings: Surroundings) -> Array[BounceRecord]:
	var bounces: Array[BounceRecord] = []
	fly(ball, seconds, surroundings.gravity)
	for segment in _overlapping(ball, surroundings):
		# Putting the ball back from one line may have freed it from the next.
		var overlap := SegmentOverlap.with_segment(ball.position, ball.radius, segment)
		if overlap.hit:
			ball.position = overlap.position
			bounce(ball, overlap, surroundings.bounciness, bounces)
	return bounces


func _overlapping(ball: Ball, surroundings: Surroundings) -> Array[LineSegment]:
	var found: Array[LineSegment] = []
	for index in surroundings.near_segments(ball.position, Vec2.new(), ball.radius):
		var segment := surroundings.segments[index]
		if SegmentOverlap.with_segment(ball.position, ball.radius, segment).hit:
			found.append(segment)
	return found
