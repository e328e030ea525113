class_name SteppingMethods
extends RefCounted
## The four ways of stepping a [SteppedWorld], and the mover of each. The list is kept apart from
## the world, so that a game that steps in one way does not carry the other three.

## The ways of stepping: [PositionResetMover], [PointOfImpactMover], [WholeFrameMover] and
## [EventMover].
enum Method { POSITION_RESET, POINT_OF_IMPACT, WHOLE_FRAME, EVENT_WORLD }


## A new mover that steps by [param method].
static func mover_of(method: Method) -> BallMover:
	match method:
		Method.POSITION_RESET:
			return PositionResetMover.new()
		Method.POINT_OF_IMPACT:
			return PointOfImpactMover.new()
		Method.EVENT_WORLD:
			return EventMover.new()
	return WholeFrameMover.new()
