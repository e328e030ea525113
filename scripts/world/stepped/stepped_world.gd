class_name SteppedWorld
extends RefCounted
## Balls among lines, moved frame by frame as in the course. Its [member mover] is the way of
## stepping, so that different ways can be compared. The balls do not touch each other.
##
## What cannot be taken is refused: [method set_balls], [method step], [method change_ball] and
## [method put_state] return "", or one sentence with the value and what is allowed; then nothing
## has changed.

## Pixels. A ball farther than this from the origin in x or y is lost: it is no longer moved.
const REACH := 800.0
## The longest step, in seconds.
const LONGEST_STEP := 1.0

# A ball overlaps a line where it is deeper in it than this, in pixels.
const _TOUCH := 1e-6
# A ball this near to a line, in pixels, lies on it: in the simple ways a resting ball makes hops.
const _NEAR := 0.1
const _NUMBERS_IN_FRONT := 3
const _NUMBERS_PER_BALL := 5

## Lines, gravity and bounciness.
var surroundings := Surroundings.new()
## Read them; change them by [method set_balls].
var balls: Array[Ball] = []
## For each ball, 1 if it is lost, otherwise 0.
var is_lost: PackedByteArray = []
## Steps made so far.
var frames := 0
## Bounces of all balls so far.
var bounces := 0
## How often a ball has been lost so far, brought back or not.
var losses := 0
## The bounces of the latest step.
var latest_bounces: Array[BounceRecord] = []
## What moves the balls.
var mover: BallMover

# For each ball, 1 if the last frame did not change it. Then the next frame will not either, as long
# as nothing else changes, and the ball is skipped.
var _is_still: PackedByteArray = []
# The step length, surroundings and mover for which that holds.
var _frame_kind: Array = []
# The surroundings that the balls have been pushed out of, and their number of changes; null at the
# start, where no ball is pushed out.
var _known: Surroundings
var _known_changes := 0


## An empty world whose balls are moved by [param with_mover], such as a [WholeFrameMover].
func _init(with_mover: BallMover) -> void:
	mover = with_mover


## Replaces all balls by copies of these, and sets all counters to 0.
func set_balls(new_balls: Array[Ball]) -> String:
	var copies: Array[Ball] = []
	for ball in new_balls:
		var problem := _problem_of(ball)
		if problem:
			return problem
		copies.append(ball.copy())
	balls = copies
	is_lost.resize(balls.size())
	is_lost.fill(0)
	_wake()
	_known = null
	frames = 0
	bounces = 0
	losses = 0
	latest_bounces.clear()
	return ""


## Moves every ball that is not lost by [param seconds], above 0 and at most
## [constant LONGEST_STEP]; another number is refused. Where the [member mover] refuses to move a
## ball to the end of the step, that ball stays where it got to, the others move on, and the
## mover's sentence is returned.
func step(seconds: float) -> String:
	if not (seconds > 0.0 and seconds <= LONGEST_STEP):
		return "A step must last above 0 and at most 1 s, not %s." % seconds
	frames += 1
	latest_bounces.clear()
	push_out_balls()
	_wake_where_changed(seconds)
	var refusal := ""
	for i in balls.size():
		if is_lost[i] == 0 and _is_still[i] == 0:
			_move(i, seconds)
			if mover.refusal and not refusal:
				refusal = mover.refusal
	return refusal


## Sets position and velocity of one ball; its spin stays, and a lost ball is back in play.
func change_ball(index: int, position: Vec2, velocity: Vec2) -> String:
	var changed := balls[index].copy()
	changed.position = position.copy()
	changed.velocity = velocity.copy()
	var problem := _problem_of(changed)
	if not problem:
		bring_back(index, changed)
		_push_out(index)
	return problem


## Pushes balls out of the lines that were changed since the last time: the rule of overlap of all
## ways of stepping that know ends of lines, see [PushOut]. A ball that lay on a line stays on its
## side. A ball that overlaps a line at its start is left there. [method step] does this first.
func push_out_balls() -> void:
	if _known and _known_changes == surroundings.changes:
		return
	if _known:
		for index in balls.size():
			if is_lost[index] == 0:
				_push_out(index)
	_known = surroundings.copy()
	_known_changes = surroundings.changes


## Replaces a lost ball by a copy of [param ball], which is in play.
func bring_back(index: int, ball: Ball) -> void:
	balls[index] = ball.copy()
	is_lost[index] = 0
	_wake()


## Whether a ball at [param position] is in play, not lost.
static func reaches(position: Vec2) -> bool:
	# Not "greater": of NaN every comparison is false.
	return absf(position.x) <= REACH and absf(position.y) <= REACH


## The number of balls that are lost now.
func lost_count() -> int:
	return is_lost.count(1)


## The index of the ball whose edge is nearest to [param point], at most [param reach] pixels away;
## -1 if there is none. Lost balls are not found.
func ball_at(point: Vec2, reach: float) -> int:
	var nearest := -1
	var least := reach
	for i in balls.size():
		var gap := balls[i].position.distance_to(point) - balls[i].radius
		if gap <= least and is_lost[i] == 0:
			nearest = i
			least = gap
	return nearest


## The energy of all balls that are not lost, in px^2/s^2 times mass: m (v^2 / 2 + g h) with the
## height h above [method Surroundings.deepest].
func energy() -> float:
	var sum := 0.0
	var deepest := surroundings.deepest()
	for i in balls.size():
		if is_lost[i] == 0:
			var height := deepest - surroundings.gravity.dot(balls[i].position)
			sum += balls[i].mass * (balls[i].velocity.length_squared() / 2.0 + height)
	return sum


## A copy with all counters at 0. It shares nothing with this world but the mover, and that only if
## the mover remembers nothing. With [param only] it holds only the ball with that index.
func copy(only: int = -1) -> SteppedWorld:
	var other := SteppedWorld.new(mover.for_copy())
	other.surroundings = surroundings.copy()
	for i in balls.size():
		if only < 0 or only == i:
			other.balls.append(balls[i].copy())
			other.is_lost.append(is_lost[i])
	other._wake()
	return other


## The moving part as plain numbers: the counters, then position, velocity and loss of each ball.
func state() -> PackedFloat64Array:
	var packed: PackedFloat64Array = [frames, bounces, losses]
	for i in balls.size():
		var ball := balls[i]
		packed.append_array(
			[ball.position.x, ball.position.y, ball.velocity.x, ball.velocity.y, is_lost[i]]
		)
	return packed


## Puts back what [method state] has returned, to the last bit.
func put_state(packed: PackedFloat64Array) -> String:
	var wanted := _NUMBERS_IN_FRONT + _NUMBERS_PER_BALL * balls.size()
	if packed.size() != wanted:
		var sizes := [balls.size(), wanted, packed.size()]
		return "The state of %d balls has %d numbers, not %d." % sizes
	for number in packed:
		if not is_finite(number):
			return "The numbers of a state must be finite, not %s." % number
	frames = int(packed[0])
	bounces = int(packed[1])
	losses = int(packed[2])
	latest_bounces.clear()
	_wake()
	for i in balls.size():
		_put_ball(i, packed, _NUMBERS_IN_FRONT + _NUMBERS_PER_BALL * i)
	return ""


func _put_ball(index: int, packed: PackedFloat64Array, at: int) -> void:
	balls[index].position.set_xy(packed[at], packed[at + 1])
	balls[index].velocity.set_xy(packed[at + 2], packed[at + 3])
	is_lost[index] = int(packed[at + 4])


func _move(index: int, seconds: float) -> void:
	var ball := balls[index]
	var x := ball.position.x
	var y := ball.position.y
	var across := ball.velocity.x
	var down := ball.velocity.y
	var records := mover.move(ball, seconds, surroundings)
	if ball.position.x == x and ball.position.y == y:
		if ball.velocity.x == across and ball.velocity.y == down:
			_is_still[index] = 1
	for record in records:
		record.ball_index = index
	bounces += records.size()
	latest_bounces.append_array(records)
	if not reaches(ball.position):
		is_lost[index] = 1
		losses += 1


func _push_out(index: int) -> void:
	if not mover.pushes_out():
		return
	var ball := balls[index]
	var here := Vec2.zero()
	var touched: PackedInt32Array = []
	# Where a line has come or gone, it is not known which is which.
	if _known and _known.segments.size() == surroundings.segments.size():
		touched = _known.near_segments(ball.position, here, ball.radius + _NEAR)
	if touched or surroundings.near_segments(ball.position, here, ball.radius):
		var push := PushOut.new(ball.position, ball.radius, _TOUCH)
		for place in surroundings.segments.size():
			var line := surroundings.segments[place]
			var side := 0.0
			if place in touched:
				var old := _known.segments[place]
				side = PushOut.side_touched(old, ball.position, ball.radius + _NEAR)
				side = PushOut.side_after(side, old, line)
			push.add_line(line, side)
		ball.position = push.position()


func _wake() -> void:
	_is_still.resize(balls.size())
	_is_still.fill(0)


func _wake_where_changed(seconds: float) -> void:
	var frame_kind := [seconds, surroundings.changes, mover]
	if frame_kind != _frame_kind:
		_frame_kind = frame_kind
		_wake()


static func _problem_of(ball: Ball) -> String:
	if not reaches(ball.position):
		return "A ball must be within -800..800 px in x and y, not at %s." % ball.position
	return ball.problem(Surroundings.LARGEST)
