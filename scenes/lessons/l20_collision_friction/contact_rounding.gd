class_name ContactRounding
extends RefCounted
## How far rounding alone may move a ball after its contact: eps times the condition over all the
## numbers that its place hangs on, as [ShotCondition] has it.


## Off a line, in pixels; [param flight] is that of [param contact] under [param gravity].
static func off_line(contact: FrictionContact, flight: ContactFlight, gravity: Vec2) -> float:
	var line := flight.line
	var numbers := _numbers_of(contact, flight)
	numbers.append_array([line.start.x, line.start.y, line.end.x, line.end.y, gravity.y])
	return ShotCondition.EPSILON * ShotCondition.of(numbers, _place_off_line)


## Of the ball that was at rest.
static func of_two(contact: FrictionContact, flight: ContactFlight) -> float:
	var numbers := _numbers_of(contact, flight)
	numbers.append_array([contact.other.position.x, contact.other.position.y])
	return ShotCondition.EPSILON * ShotCondition.of(numbers, _place_of_second)


# What both have, in this order: the start, the velocity there, spin, radius, C and µ; then the
# times before and after the contact.
static func _numbers_of(contact: FrictionContact, flight: ContactFlight) -> PackedFloat64Array:
	var start := flight.start
	return [
		start.position.x,
		start.position.y,
		start.velocity.x,
		start.velocity.y,
		start.spin,
		start.radius,
		contact.bounciness,
		contact.friction,
		flight.contact_time,
		flight.compared_after
	]


static func _place_off_line(n: PackedFloat64Array) -> Vec2:
	var gravity := Vec2.new(0.0, n[14])
	var ball := Ball.new(Vec2.new(n[0], n[1]), n[5], Vec2.new(n[2], n[3]), 1.0, n[4])
	var from := Vec2.new(n[10], n[11])
	var along := Vec2.new(n[12], n[13]).minus(from)
	var contact := FrictionContact.new(ball, along, n[6], n[7])
	_fly(ball, gravity, n[8])
	var gap := ball.position.minus(from).dot(contact.normal) - n[5]
	var early := -gap / ball.velocity.dot(contact.normal)
	_fly(ball, gravity, early)
	contact.ball.velocity = ball.velocity
	ball.velocity = _leaving(contact)[0].velocity
	_fly(ball, gravity, n[9] - early)
	return ball.position


static func _place_of_second(n: PackedFloat64Array) -> Vec2:
	var ball := Ball.new(Vec2.new(n[0], n[1]), n[5], Vec2.new(n[2], n[3]), 1.0, n[4])
	var other := Ball.new(Vec2.new(n[10], n[11]), n[5])
	var nothing := Vec2.zero()
	_fly(ball, nothing, n[8])
	var apart := ball.position.minus(other.position)
	var early := -(apart.length() - 2.0 * n[5]) / ball.velocity.dot(apart.normalized())
	_fly(ball, nothing, early)
	# The surface runs across the line of the centres.
	var across := ball.position.minus(other.position).normal()
	var contact := FrictionContact.new(ball, across, n[6], n[7], other)
	other.velocity = _leaving(contact)[1].velocity
	_fly(other, nothing, n[9] - early)
	return other.position


# As [method FrictionContact.after], also for a C that is changed to be a little above 1.
static func _leaving(contact: FrictionContact) -> Array[Ball]:
	return contact.after_with(contact.grip(), contact.grip())


static func _fly(ball: Ball, gravity: Vec2, seconds: float) -> void:
	var way := ball.velocity.plus(gravity.scaled(0.5 * seconds)).scaled(seconds)
	ball.position.add(way)
	ball.velocity.add(gravity.scaled(seconds))
