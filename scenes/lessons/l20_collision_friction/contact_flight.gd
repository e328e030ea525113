class_name ContactFlight
extends RefCounted
## The flight before and after a contact, in the event world: how far the balls have come and turned
## at any moment, and where else they touch.
##
## The ball starts so that it comes to the contact with the velocity and the spin of the contact.

## The ball comes for so many seconds at most, and is followed for so many afterwards.
const LONGEST_SIDE := 0.3
# Under gravity it is followed for so many touches, and so many seconds at most.
const _HOPS := 3
const _LONGEST := 6.0
# The line reaches so much farther than the ball flies.
const _SPARE := 1.25

## Seconds until the contact.
var contact_time := LONGEST_SIDE
## Seconds from the contact to the moment at which the formula is compared with the world.
var compared_after := LONGEST_SIDE
## When the flight ends.
var end := 2.0 * LONGEST_SIDE
## The line; null where two balls meet.
var line: LineSegment
## The ball at the start.
var start: Ball

var _contact: FrictionContact
var _gravity: Vec2
var _friction: float
var _world := EventWorld.new()
var _first: WorldSnapshot


## The flight of [param contact] under [param gravity], in px/s², with the friction
## [param friction], which may be another one than that of the contact.
func _init(contact: FrictionContact, gravity: Vec2, friction: float) -> void:
	_contact = contact
	_gravity = gravity
	_friction = friction
	_choose_times()
	var came := gravity.scaled(contact_time)
	start = contact.ball.copy()
	start.velocity.subtract(came)
	# Back from the contact: v T less half of what gravity does on the way.
	var flown := contact.ball.velocity.minus(came.scaled(0.5)).scaled(contact_time)
	start.position.subtract(flown)
	_set_up()


## Goes to the moment [param seconds] after the start.
func go_to(seconds: float) -> void:
	if seconds < _world.time:
		Refusal.push(_world.restore(_first))
		_world.events.clear()
	Refusal.push(_world.advance_to(seconds))


## Ball [param index] as it is now: 0 the one that came, 1 the one at rest.
func ball(index: int) -> Ball:
	return _world.ball(index)


## How far it has turned since the start, in radians, clockwise on screen.
func angle(index: int) -> float:
	return _world.angle(index)


## Where the ball is compared: the one that came; of two balls the one that was at rest.
func compared_ball() -> int:
	return 1 if _contact.other else 0


## Where that ball is at the moment of the comparison, by the event world.
func compared_place() -> Vec2:
	go_to(contact_time + compared_after)
	return _world.position(compared_ball())


## Where it is then by the formula: straight on, or along a parabola, with the velocity after the
## contact.
func place_by_formula() -> Vec2:
	var leaving := _contact.after()[compared_ball()]
	var mean := leaving.velocity.plus(_gravity.scaled(0.5 * compared_after))
	return leaving.position.plus(mean.scaled(compared_after))


## How far both are from each other, in pixels.
func miss() -> float:
	return compared_place().distance_to(place_by_formula())


## Places of ball [param index] along its way from the start until [param last] seconds: so many
## equal [param pieces] of time, and where it touches.
func way(index: int, last: float, pieces: int) -> Array[Vec2]:
	var times: PackedFloat64Array = []
	for piece: int in pieces + 1:
		times.append(last * piece / pieces)
	for event in _touches(last):
		times.append(event.time)
	times.sort()
	var found: Array[Vec2] = []
	for seconds in times:
		go_to(seconds)
		found.append(_world.position(index))
	return found


## What each touch of the line did, in order, until the end.
func regimes() -> Array[Friction.Regime]:
	var found: Array[Friction.Regime] = []
	for event in _touches(end):
		found.append(_regime_of(event))
	return found


func _touches(last: float) -> Array[WorldEvent]:
	go_to(0.0)
	_world.keeps_events = true
	go_to(last)
	_world.keeps_events = false
	var found := _world.events.filter(
		func(event: WorldEvent) -> bool:
			return event.ball == 0 and event.kind in [WorldEvent.Kind.SEGMENT, WorldEvent.Kind.BALL]
	)
	_world.events.clear()
	return found


func _regime_of(event: WorldEvent) -> Friction.Regime:
	var tangent := Vec2.new(-event.normal.y, event.normal.x)
	var slip := event.velocity_before.dot(tangent) - _contact.ball.radius * event.spin_before
	var change := event.velocity_after.minus(event.velocity_before)
	return Friction.regime(slip, change.dot(event.normal), _friction)


# Under gravity the ball comes down from where it is highest above the line at most, and is compared
# before it touches again.
func _choose_times() -> void:
	var presses := -_gravity.dot(_contact.normal)
	if presses <= 0.0:
		return
	var approach := -_contact.normal_speed()
	contact_time = minf(contact_time, approach / presses)
	var hop := 2.0 * _contact.bounciness * approach / presses
	compared_after = minf(compared_after, hop)
	var hops := LONGEST_SIDE
	for number: int in _HOPS:
		hops += hop * _contact.bounciness ** number
	end = contact_time + minf(hops, _LONGEST)


func _set_up() -> void:
	Refusal.push(_world.set_bounciness(_contact.bounciness))
	Refusal.push(_world.set_friction(_friction))
	var balls: Array[Ball] = [start]
	if _contact.other:
		balls.append(_contact.other)
	else:
		Refusal.push(_world.set_gravity(_gravity))
		line = _line()
		Refusal.push(_world.set_segments([line]))
	Refusal.push(_world.set_balls(balls))
	_first = _world.snapshot()


# Long enough for all of the flight, and not longer: the places on a long line have fewer digits
# behind the point.
func _line() -> LineSegment:
	var pulled := 0.5 * _gravity.length() * end
	var fastest := _contact.speed_scale() + pulled
	var half := _contact.tangent.scaled(_SPARE * fastest * end + 2.0 * start.radius)
	return LineSegment.new(half.negated(), half)
