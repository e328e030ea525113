class_name EngineShotCases
extends RefCounted
## The engine's own methods for the flight of one ball.


## All methods for the ball in the box.
static func in_box(is_quick: bool, host: Node) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for shot in BallInBoxProblem.shots():
		var is_long := shot.seconds == BallInBoxProblem.LONG
		for rate in BallInBoxProblem.rates(shot, is_quick):
			if rate <= 960:
				found.append_array(moved(host, shot, rate))
		if not (is_long and is_quick):
			for rate in _rigid_rates(is_long, is_quick):
				found.append_array(rigid(host, shot, rate, is_long or is_quick))
	return found


## All methods for the ball among angled lines.
static func among_lines(is_quick: bool, host: Node) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	var shot := LinesShot.new()
	for rate in AngledLinesProblem.rates(is_quick):
		found.append_array(moved(host, shot, rate))
		found.append_array(rigid(host, shot, rate, true))
	return found


## The methods for the ball among many segments, which form one concave shape: among as many
## separate shapes a body jams.
static func among_many(host: Node) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for count in ManySegmentsProblem.COUNTS:
		var shot := ManySegmentsShot.new(count)
		found.append(CollideFlight.new(host, true, shot, 60))
		found.append(MotionTestFlight.new(host, true, shot, 60))
	return found


## Flights by move_and_collide and body_test_motion, each with separate segments and with one
## concave shape.
static func moved(host: Node, shot: Shot, rate: int) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for is_one_shape: bool in [false, true]:
		found.append(CollideFlight.new(host, is_one_shape, shot, rate))
		found.append(MotionTestFlight.new(host, is_one_shape, shot, rate))
	return found


# Physics frames are slow, so the long flight has few of them.
static func _rigid_rates(is_long: bool, is_quick: bool) -> PackedInt32Array:
	if is_long:
		return [60]
	return [60, 240] if is_quick else [60, 240, 960]


## Flights by RigidBody2D, without and with continuous detection. [param are_few] leaves out the
## detection that casts the shape, because it differs little from none.
static func rigid(host: Node, shot: Shot, rate: int, are_few: bool) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for mode in RigidFlight.MODES:
		if not are_few or mode != RigidBody2D.CCD_MODE_CAST_SHAPE:
			found.append(RigidFlight.new(host, mode, shot, rate))
	return found
