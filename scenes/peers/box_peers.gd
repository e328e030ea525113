class_name BoxPeers
extends RefCounted
## The engine's own ways to fly the ball in the box.

# Steps a second.
const _RATES: PackedInt32Array = [60, 240, 960]
const _FEW_RATES: PackedInt32Array = [60, 240]
const _ONE_RATE: PackedInt32Array = [60]
const _NONE: PackedInt32Array = []


## Fresh cases; see [method PeerCases.of].
static func cases(is_quick: bool, host: Node) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for speed in BallInBoxProblem.SPEEDS:
		for rate in _FEW_RATES if is_quick else _RATES:
			found.append_array(_moved(host, speed, BallInBoxProblem.SHORT, rate))
			found.append_array(_rigid(is_quick, host, speed, BallInBoxProblem.SHORT, rate))
		for rate in _ONE_RATE if is_quick else _RATES:
			found.append_array(_moved(host, speed, BallInBoxProblem.LONG, rate))
		for rate in _NONE if is_quick else _FEW_RATES:
			found.append_array(_rigid(is_quick, host, speed, BallInBoxProblem.LONG, rate))
	return found


static func _moved(host: Node, speed: float, seconds: float, rate: int) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for is_one_shape: bool in [false, true]:
		found.append(CollideBoxFlight.new(host, is_one_shape, speed, seconds, rate))
		found.append(MotionTestBoxFlight.new(host, is_one_shape, speed, seconds, rate))
	return found


static func _rigid(
	is_quick: bool, host: Node, speed: float, seconds: float, rate: int
) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for mode in RigidBoxFlight.MODES:
		if not is_quick or mode != RigidBody2D.CCD_MODE_CAST_SHAPE:
			found.append(RigidBoxFlight.new(host, mode, speed, seconds, rate))
	return found
