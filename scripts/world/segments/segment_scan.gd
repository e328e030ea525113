class_name SegmentScan
extends SegmentList
## The first of many segments that a flying ball meets, found by looking at all. [SegmentGrid] finds
## the same impact by looking at those near the path.
##
## The answer is what [StraightImpactFinder] and [AcceleratedImpactFinder] say of each segment. The
## steps of the first are written out here: every prediction of an [EventWorld] among segments runs
## through them, and the first few rule out most segments.

## What a ball touches already while it looks for the next impact: nothing, a line on which it lies,
## a point round which it slides, or a point that it has just left.
enum Contact { NONE, LINE, POINT, LEFT_POINT }

## What is around a ball that touches something: it can leave; hurried bounces between surfaces that
## move would never end; it is crushed after [member crush_seconds].
enum Squeeze { NONE, SHAKEN, CRUSHED }

## A ball that is no farther than this from touching a line or a cap, in pixels, touches it:
## rounding may move it this far.
const TOUCH := 1e-9

## What rounding adds to that where coordinates are large, as a share of them.
const ROUNDING := 8.0 / 2.0 ** 52

# A ball touches a belt that is this near to it, in pixels.
const _BELT_GAP := 1e-6
# Two ends that are no farther than this from each other are at the same joint, as a share of the
# radius of the ball that passes them.
const _WIDEST_GAP := 1e-2

## Seconds until the impact that was found.
var time := INF
## The segment that is met, or -1.
var index := -1
## What of the segment is met.
var feature := Impact.Feature.LINE
## Seconds until a ball is crushed, and the velocity with which it has room until then, in px/s.
var crush_seconds := INF
## See [member crush_seconds].
var crush_velocity: Vec2
## The segment that the ball touches already, or -1: see [method lie_on_line].
var contact_place := -1
## How fast the surfaces of belts run, in px/s from start to end, by the places of their segments.
var belts: Dictionary[int, float] = {}

# The flight that is looked at: pixels, seconds.
var _x := 0.0
var _y := 0.0
var _velocity_x := 0.0
var _velocity_y := 0.0
var _pull_x := 0.0
var _pull_y := 0.0
var _radius := 0.0
var _skipped := -1
# The square of the radius times the speed, and a little more for rounding.
var _reach_squared := 0.0
var _slack := TOUCH
var _contact := Contact.NONE
var _contact_x := 0.0
var _contact_y := 0.0
var _contact_normal_x := 0.0
var _contact_normal_y := 0.0
var _straight := StraightImpactFinder.new()
var _accelerated := AcceleratedImpactFinder.new()


## Whether a ball in straight flight meets a segment within [param horizon] seconds; the segment at
## the place [param skipped] is left out.
func first_impact(
	x: float,
	y: float,
	velocity_x: float,
	velocity_y: float,
	radius: float,
	horizon: float,
	skipped: int = -1
) -> bool:
	_ask(x, y, velocity_x, velocity_y, radius, horizon, skipped)
	for place in size():
		_try(place)
	return index >= 0


## The same under the constant acceleration [param pull_x], [param pull_y] in px/s^2.
func first_accelerated_impact(
	x: float,
	y: float,
	velocity_x: float,
	velocity_y: float,
	pull_x: float,
	pull_y: float,
	radius: float,
	horizon: float,
	skipped: int = -1
) -> bool:
	_ask(x, y, velocity_x, velocity_y, radius, horizon, skipped)
	_ask_accelerated(pull_x, pull_y)
	for place in size():
		_try_accelerated(place)
	_end_contact()
	return index >= 0


## Whether a ball under the same acceleration meets one of the round ends of the segment at that
## place, if this goes on to move as it does now.
func first_end(
	place: int,
	x: float,
	y: float,
	velocity_x_now: float,
	velocity_y_now: float,
	pull_x: float,
	pull_y: float,
	radius: float,
	horizon: float
) -> bool:
	var seen_x := velocity_x_now - segment_velocity_x(place)
	var seen_y := velocity_y_now - segment_velocity_y(place)
	_accelerated.set_flight(x, y, seen_x, seen_y, pull_x, pull_y, radius)
	time = minf(horizon, seconds_left(place))
	index = -1
	for end: Impact.Feature in [Impact.Feature.START, Impact.Feature.END]:
		if _accelerated.with_point(end_x(place, end), end_y(place, end), time):
			_take(place, _accelerated.time, end)
	return index >= 0


## Tells before [method first_accelerated_impact] that the ball lies on the line through (x, y) with
## the unit normal (up_x, up_y), towards the ball. Then it can meet nothing that does not rise above
## the line, such as the end of the next line at a joint.
func lie_on_line(x: float, y: float, up_x: float, up_y: float) -> void:
	_contact = Contact.LINE
	_contact_normal_x = up_x
	_contact_normal_y = up_y
	_contact_x = x
	_contact_y = y


## Tells that the ball slides round the point (x, y), where segments end: it meets none of them.
func slide_round(x: float, y: float) -> void:
	_contact = Contact.POINT
	_contact_x = x
	_contact_y = y


## Tells that the ball flies off the point (x, y), where segments end: it may meet their lines, but
## not their caps at this point.
func leave_point(x: float, y: float) -> void:
	_contact = Contact.LEFT_POINT
	_contact_x = x
	_contact_y = y


## Whether a segment moves, or its surface does. Here all segments rest; scripts/world/motion/ has
## those that move, and the next methods are about these.
func has_motion() -> bool:
	return belts.values().any(func(speed: float) -> bool: return speed != 0.0)


## Puts the segments where they are at this time of the world, the sum of two numbers.
func go_to(_time: float, _low: float) -> void:
	pass


## Sees everything from the segment at that place; from where the world rests for -1.
func see_from(_place: int) -> void:
	pass


## x of the velocity of the segment at that place, in px/s; 0 for one that turns.
func segment_velocity_x(_place: int) -> float:
	return 0.0


## y of the velocity.
func segment_velocity_y(_place: int) -> float:
	return 0.0


## The velocity of the point of the segment at that place that is here now, in px/s, without belt.
func velocity_at(_place: int, _point: Vec2) -> Vec2:
	return Vec2.zero()


## How fast and in which direction the belt of the segment at that place runs, in px/s.
func belt_velocity(place: int) -> Vec2:
	if not belts.has(place):
		return Vec2.zero()
	return Vec2.new(normal_y(place), -normal_x(place)).scaled(belts[place])


## How fast the segment at that place turns, in rad/s.
func turn_of(_place: int) -> float:
	return 0.0


## For how many seconds the segment at that place goes on to move as it does now.
func seconds_left(_place: int) -> float:
	return INF


## How strongly a segment that turns is pressed on a ball that touches it, in px/s²: what keeps the
## ball from flying on straight, as seen from the segment. The unit normal points to the ball.
func pressure_at(_place: int, _centre: Vec2, _velocity: Vec2, _normal: Vec2) -> float:
	return 0.0


## What is around a ball that touches something; [param is_hurried] after many touches one right
## after the other.
func squeeze_of(of_ball: Ball, is_hurried: bool) -> Squeeze:
	var at := of_ball.position
	if is_hurried and is_near_belt(at.x, at.y, of_ball.radius):
		return Squeeze.SHAKEN
	return Squeeze.NONE


## Whether a ball at this point touches a belt.
func is_near_belt(x: float, y: float, radius: float) -> bool:
	for place: int in belts:
		if belts[place] != 0.0 and distance_to_segment(place, x, y) <= radius + _BELT_GAP:
			return true
	return false


## Whether a ball at this point touches a belt or what moves.
func has_motion_near(x: float, y: float, radius: float) -> bool:
	return is_near_belt(x, y, radius)


# The ball touches nothing.
func _end_contact() -> void:
	_contact = Contact.NONE
	_accelerated.skips_start = false
	_accelerated.skips_end = false


func _ask(
	x: float,
	y: float,
	velocity_x: float,
	velocity_y: float,
	radius: float,
	horizon: float,
	skipped: int
) -> void:
	_x = x
	_y = y
	_velocity_x = velocity_x
	_velocity_y = velocity_y
	_radius = radius
	_skipped = skipped
	_reach_squared = (
		1.000001 * radius * radius * (velocity_x * velocity_x + velocity_y * velocity_y)
	)
	time = horizon
	index = -1


func _ask_accelerated(pull_x: float, pull_y: float) -> void:
	_pull_x = pull_x
	_pull_y = pull_y
	_accelerated.set_flight(_x, _y, _velocity_x, _velocity_y, pull_x, pull_y, _radius)
	_slack = TOUCH + ROUNDING * (absf(_x) + absf(_y))


# Takes the segment at that place if the ball meets it before all that were tried.
func _try(place: int) -> void:
	var start_x := _start_x[place]
	var start_y := _start_y[place]
	var along_x := _end_x[place] - start_x
	var along_y := _end_y[place] - start_y
	# As in StraightImpactFinder: distance from the line and approach to it, both times the length
	# of the segment.
	var distance := along_x * (_y - start_y) - along_y * (_x - start_x)
	var approach := along_y * _velocity_x - along_x * _velocity_y
	if distance < 0.0:
		distance = -distance
		approach = -approach
	var gap := distance - _radius * _length[place]
	if gap > 0.0 and (gap > approach * time or approach <= 0.0):
		return
	if _is_there[place] == 0 or place == _skipped:
		return
	if gap <= 0.0:
		_try_from_near(place)
		return
	# Where along the line the ball meets it; beyond an end it can meet only the cap there.
	var seconds := gap / approach
	var along := (
		along_x * (_x - start_x)
		+ along_y * (_y - start_y)
		+ (along_x * _velocity_x + along_y * _velocity_y) * seconds
	)
	if along < 0.0:
		_try_end(place, start_x, start_y, Impact.Feature.START)
	elif along > along_x * along_x + along_y * along_y:
		_try_end(place, _end_x[place], _end_y[place], Impact.Feature.END)
	else:
		_take(place, seconds, Impact.Feature.LINE)


# The ball starts nearer to the line than its radius.
func _try_from_near(place: int) -> void:
	if _straight.with_segment(
		_x,
		_y,
		_velocity_x,
		_velocity_y,
		_radius,
		_start_x[place],
		_start_y[place],
		_end_x[place],
		_end_y[place]
	):
		_take(place, _straight.time, _straight.feature)


# The ball passes most caps at a distance, so that is tested first.
func _try_end(place: int, x: float, y: float, end: Impact.Feature) -> void:
	var offset := (_x - x) * _velocity_y - (_y - y) * _velocity_x
	if offset * offset <= _reach_squared:
		if _straight.with_point(_x, _y, _velocity_x, _velocity_y, _radius, x, y):
			_take(place, _straight.time, end)


func _try_accelerated(place: int) -> void:
	var start_x := _start_x[place]
	var start_y := _start_y[place]
	var along_x := _end_x[place] - start_x
	var along_y := _end_y[place] - start_y
	var distance := along_x * (_y - start_y) - along_y * (_x - start_x)
	var approach := along_y * _velocity_x - along_x * _velocity_y
	var pull := along_y * _pull_x - along_x * _pull_y
	if distance < 0.0:
		distance = -distance
		approach = -approach
		pull = -pull
	var gap := distance - _radius * _length[place]
	# What touches is looked at in any case, so that the order of the segments makes no difference.
	var touches := gap <= _slack * _length[place]
	# Ruled out if it is too far away, with the pull taken into account only where it helps.
	if not touches and gap > (approach + 0.5 * maxf(pull, 0.0) * time) * time and time < INF:
		return
	if _is_there[place] == 0 or place == _skipped:
		return
	if _contact != Contact.NONE and not _rises_from_contact(place):
		return
	if touches and _lies_on(place, gap, approach, pull):
		return
	if _accelerated.with_segment(start_x, start_y, _end_x[place], _end_y[place], time):
		_take(place, _accelerated.time, _accelerated.feature)


# Whether the ball can meet the segment at that place although it touches something already; notes
# which of the two caps it cannot meet.
func _rises_from_contact(place: int) -> bool:
	var skips_start := _is_at_contact(_start_x[place], _start_y[place])
	var skips_end := _is_at_contact(_end_x[place], _end_y[place])
	_accelerated.skips_start = skips_start or _is_behind(_start_x[place], _start_y[place])
	_accelerated.skips_end = skips_end or _is_behind(_end_x[place], _end_y[place])
	match _contact:
		Contact.POINT:
			return not (skips_start or skips_end)
		Contact.LEFT_POINT:
			# Of the lines that end at the point it can meet those ahead.
			var along_x := _end_x[place] - _start_x[place]
			var along_y := _end_y[place] - _start_y[place]
			var ahead := along_x * _velocity_x + along_y * _velocity_y
			return not (skips_start and ahead <= 0.0 or skips_end and ahead >= 0.0)
	return not (skips_start and skips_end)


# Whether a cap about this point is no more than what the ball touches already.
func _is_at_contact(x: float, y: float) -> bool:
	var dx := x - _contact_x
	var dy := y - _contact_y
	if _contact == Contact.LINE:
		return dx * _contact_normal_x + dy * _contact_normal_y <= _slack
	return dx * dx + dy * dy <= _slack * _slack


# Whether a ball that goes round the point of contact, or has left it, cannot meet a cap about this
# point, because it has just passed it: at a joint with a gap there is one beside the other.
func _is_behind(x: float, y: float) -> bool:
	if _contact == Contact.LINE:
		return false
	var dx := x - _contact_x
	var dy := y - _contact_y
	var gap := _WIDEST_GAP * _radius
	return dx * dx + dy * dy <= gap * gap and dx * _velocity_x + dy * _velocity_y <= 0.0


# Of two that are met at the same time, the one at the smaller place is taken, in whatever order
# they are tried.
func _take(place: int, seconds: float, of: Impact.Feature) -> void:
	if seconds < time or (seconds == time and place < index):
		time = seconds
		index = place
		feature = of


# A ball that touches a segment, hardly moves along its normal and is pulled into it meets it at
# once, or when it has fallen back to where it is: it was never clear of the segment, and must not
# sink into it. A ball that is put down inside a segment lies on it, too. Gap, approach and pull are
# multiplied by the length of the segment.
func _lies_on(place: int, gap: float, approach: float, pull: float) -> bool:
	var share := share_of(place, _x, _y)
	var is_over := share >= 0.0 and share <= 1.0
	var skips_cap := _accelerated.skips_start if share < 0.0 else _accelerated.skips_end
	if skips_cap and not is_over and _contact != Contact.LEFT_POINT:
		return false
	if is_over or _comes_over(place, share):
		var slack := _slack * _length[place]
		if (gap >= -slack or _contact == Contact.NONE) and _is_held(approach, pull, slack):
			_take(place, 2.0 * maxf(-approach, 0.0) / pull, Impact.Feature.LINE)
			return true
	if is_over or skips_cap:
		return false
	var of := Impact.Feature.START if share < 0.0 else Impact.Feature.END
	var dx := _x - end_x(place, of)
	var dy := _y - end_y(place, of)
	var distance := sqrt(dx * dx + dy * dy)
	var depth := _radius - distance
	if depth < -_slack or (depth > _slack and _contact != Contact.NONE):
		return false
	var speed := -(_velocity_x * dx + _velocity_y * dy) / distance
	# Around a point there is the centrifugal acceleration, too.
	var around := (_velocity_x * dy - _velocity_y * dx) / distance
	var inwards := -(_pull_x * dx + _pull_y * dy) / distance - around * around / distance
	if not _is_held(speed, inwards, _slack):
		return false
	_take(place, 2.0 * maxf(-speed, 0.0) / inwards, of)
	return true


# Whether a ball beside an end of a segment that it touches is about to be over the line, and so
# near to the end that line and cap are as near as makes no difference.
func _comes_over(place: int, share: float) -> bool:
	var along_x := _end_x[place] - _start_x[place]
	var along_y := _end_y[place] - _start_y[place]
	var speed := _velocity_x * along_x + _velocity_y * along_y
	var beyond := -share if share < 0.0 else share - 1.0
	beyond *= _length[place]
	return speed * share < 0.0 and beyond * beyond <= 2.0 * _slack * _radius


# Whether what leaves a surface at this speed is pulled back before it has risen by this height.
func _is_held(approach: float, pull: float, height: float) -> bool:
	return pull > 0.0 and approach * approach <= 2.0 * pull * height
