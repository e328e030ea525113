class_name FramePart
extends RefCounted
## A part of a frame, from one bounce to the next: how long it lasts, which acceleration acts, and
## which lines are left out because the ball lies on them or has just left them.

## Seconds. A ball that would be back at a line sooner than this lies on it: it slides instead of
## making ever smaller hops. A larger value would swallow hops that can be seen.
const SHORTEST_HOP := 1.0 / 480.0

# Fractions of gravity or speed below this are rounding.
const _NOTHING := 1e-9

## Seconds that are left of the frame.
var left: float
## The longest time in seconds that this part can last.
var seconds: float
## The acceleration in px/s²: gravity, or its part along the line on which the ball lies.
var pull: Vec2
## The indices of the lines that are left out.
var skipped: PackedInt32Array = []

var _gravity: Vec2
# The index of the line on which the ball lies, -1 for none, and its normal.
var _support := -1
var _support_normal := Vec2.new()
# The indices of the lines that the ball passes while it moves along what it touches: the touched
# one, and those that go on from it without rising, as at a joint.
var _passed: PackedInt32Array = []


## The first part of a frame of [param frame_seconds].
func _init(frame_seconds: float, gravity: Vec2) -> void:
	left = frame_seconds
	_gravity = gravity
	_fly_freely()


## Ends this part after a flight without impact.
func pass_by() -> void:
	left -= seconds
	_fly_freely()


## Ends this part after an impact, with the velocity of [param ball] after it: the ball leaves the
## line, or lies on it. A ball that lies in a corner of two lines comes to rest, and no part is
## left.
func leave(ball: Ball, impact: Impact, has_bounced: bool, surroundings: Surroundings) -> void:
	left -= seconds * impact.fraction
	var point := ball.position.minus(impact.normal.scaled(ball.radius))
	_passed = surroundings.segments_below(ball, point, impact.normal)
	if hop_seconds(ball.velocity, impact.normal, _gravity) < SHORTEST_HOP:
		_lie_on(ball, impact)
	elif has_bounced or _support < 0:
		_fly_freely()
		_hop(ball, impact, has_bounced)
	else:
		skipped = [_support]
		_hop(ball, impact, has_bounced)


## Whether the ball lies on a line in this part.
func lies() -> bool:
	return _support >= 0


## Seconds until gravity brings a ball back to the line that it leaves: 2 v / g along the normal.
## Infinite if gravity does not press the ball against the line.
static func hop_seconds(velocity: Vec2, normal: Vec2, gravity: Vec2) -> float:
	var press := -gravity.dot(normal)
	if press <= _NOTHING * gravity.length():
		return INF
	return maxf(2.0 * velocity.dot(normal) / press, 0.0)


func _fly_freely() -> void:
	seconds = left
	pull = _gravity
	skipped = []
	_support = -1


# The way back to the line is curved, so a straight way over the whole part would miss the line. The
# part ends when the ball is back. A ball that only passes along the line, as along an upright one,
# does not meet it again.
func _hop(ball: Ball, impact: Impact, has_bounced: bool) -> void:
	var hop := hop_seconds(ball.velocity, impact.normal, pull)
	seconds = minf(hop, left)
	if hop < left or not has_bounced:
		skipped.append_array(_passed)


func _lie_on(ball: Ball, impact: Impact) -> void:
	ball.velocity = ball.velocity.rejection(impact.normal)
	pull = _gravity.rejection(impact.normal)
	seconds = left
	skipped = _passed.duplicate()
	if _support >= 0:
		if hop_seconds(ball.velocity, _support_normal, pull) < SHORTEST_HOP:
			ball.velocity = Vec2.new()
			left = 0.0
		elif ball.velocity.dot(_support_normal) >= -_NOTHING * ball.velocity.length():
			# It leaves the other line of a corner along this one, and may slide back.
			skipped.append(_support)
			seconds = minf(hop_seconds(ball.velocity, _support_normal, pull), left)
	_support = impact.segment_index
	_support_normal = impact.normal
