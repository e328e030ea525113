class_name DroppedBallProblem
extends ReportProblem
## The fifth problem: a dropped ball, by the usual ways of stepping, by springs, and exactly.

# The numbers of steps in a second.
const _RATES: PackedInt32Array = [60, 240, 960]
const _QUICK_RATES: PackedInt32Array = [60, 960]

# The stiffnesses of the springs as powers of ten, in 1/s^2.
const _STIFFNESSES: PackedInt32Array = [2, 3, 4, 5, 6, 7, 8, 9, 10]
const _QUICK_STIFFNESSES: PackedInt32Array = [2, 4, 6, 8, 10]


func _init() -> void:
	id = "dropped_ball"
	champion = EventDrop.METHOD
	title = "A dropped ball, for a minute"
	question = (
		(
			"A ball is dropped from %d px at %d px/s^2; after %d s its height is compared with the exact"
			% [DroppedBall.HEIGHT, DroppedBall.GRAVITY, DroppedBall.SECONDS]
		)
		+ " one. Penalty springs of growing stiffness push it out of the floor."
	)
	error_axis = "error of the height, px"


## See [method ReportProblem.cases].
func cases(is_quick: bool) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for bounciness in DroppedBall.BOUNCINESSES:
		for rate in _QUICK_RATES if is_quick else _RATES:
			found.append(EventDrop.new(bounciness, rate))
			for way in IntegratorDrop.METHODS:
				found.append(IntegratorDrop.new(way, bounciness, rate))
			for power in _QUICK_STIFFNESSES if is_quick else _STIFFNESSES:
				found.append(SpringDrop.new(10.0 ** power, bounciness, rate))
	return found
