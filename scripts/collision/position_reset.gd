class_name PositionReset
extends RefCounted
## Part 12 of the lecture: a ball that has sunk into a line is put back along the normal.


## Moves the ball along the normal until it just touches the good side of the line.
static func reset(ball: Ball, line: LineSegment) -> void:
	ball.position.subtract(line.normal().scaled(LineDistance.gap(ball, line)))
