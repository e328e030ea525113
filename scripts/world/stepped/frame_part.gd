class_name FramePart
extends RefCounted
## A part of a frame from one bounce to the next: how long it lasts, what pulls, and which lines
## cannot be touched in it because the ball lies on them or has just left them.

## Seconds. A ball that would come back to the line it has left sooner than this lies on it: it
## slides instead of making endless ever smaller hops. Larger swallows hops that can be seen.
const SHORTEST_HOP := 1.0 / 480.0

# Shares of gravity or speed below this are rounding.
const _NOTHING := 1e-9

## Seconds that are left of the frame.
var left: float
## Seconds that this part lasts at most.
var seconds: float
## Gravity, or what of it the line leaves on which the ball lies.
var pull: Vec2
## Places of the lines that are left out.
var skipped: PackedInt32Array = []

var _gravity: Vec2
# The line on which the ball lies, and its normal.
var _support := -1
var _support_normal := Vec2.new()


## The first part of a frame of [param frame_seconds].
func _init(frame_seconds: float, gravity: Vec2) -> void:
	left = frame_seconds
	_gravity = gravity
	_fly_freely()


## Goes on after a part without impact.
func pass_by() -> void:
	left -= seconds
	_fly_freely()


## Goes on after an impact that [param ball] has come out of: it leaves the line, or lies on it. A
## ball that lies in a corner of two lines comes to rest and has no part left.
func leave(ball: Ball, impact: Impact, has_bounced: bool) -> void:
	left -= seconds * impact.fraction
	if hop_seconds(ball.velocity, impact.normal, _gravity) < SHORTEST_HOP:
		_lie_on(ball, impact)
	elif has_bounced or _support < 0:
		_fly_freely()
		_hop(ball, impact)
	else:
		skipped = [_support]
		_hop(ball, impact)


## Seconds until [param pull] has brought a ball back that leaves a line with this normal: 2 v / g
## along the normal. Infinite where it is not pressed on the line.
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


# The way back to the line is curved; the straight way of the whole part would miss it.
func _hop(ball: Ball, impact: Impact) -> void:
	var hop := hop_seconds(ball.velocity, impact.normal, pull)
	seconds = minf(hop, left)
	if hop < left:
		skipped.append(impact.segment_index)


func _lie_on(ball: Ball, impact: Impact) -> void:
	ball.velocity = ball.velocity.rejection(impact.normal)
	pull = _gravity.rejection(impact.normal)
	seconds = left
	skipped = [impact.segment_index]
	if _support >= 0:
		if hop_seconds(ball.velocity, _support_normal, pull) < SHORTEST_HOP:
			ball.velocity = Vec2.new()
			left = 0.0
		elif ball.velocity.dot(_support_normal) >= -_NOTHING * ball.velocity.length():
			skipped.append(_support)
	_support = impact.segment_index
	_support_normal = impact.normal
