class_name AimShot
extends RefCounted
## A bullet that leaves the nozzle of a barrel: where it is nearest to the target, and by how much
## it misses, flown in the event world.

## The direction in which the barrel points, in degrees.
var degrees := 0.0
## Seconds from the shot to the moment at which the bullet is nearest to the target.
var moment := 0.0
## The smallest distance of the centres, in pixels.
var miss := 0.0

var _model: AimAtModel
var _nozzle: Vec2
var _velocity: Vec2
var _flight: FiredShot


## The shot of [param model] along [param its_degrees], without gravity.
func _init(model: AimAtModel, its_degrees: float) -> void:
	_model = model
	degrees = its_degrees
	_nozzle = model.nozzle_at(degrees)
	_velocity = Vec2.unit_degrees(degrees).scaled(model.speed)
	_flight = FiredShot.new(_nozzle, _velocity)
	var along := model.target.minus(_nozzle).dot(_velocity) / _velocity.length_squared()
	moment = clampf(along, 0.0, 1e9)
	miss = place_after(moment).distance_to(model.target)


## Where the bullet is after [param seconds], in pixels.
func place_after(seconds: float) -> Vec2:
	return _flight.place_after(seconds)


## When its flight has been seen, in seconds: at the target, or some time after it was nearest. A
## bullet that flies away is shown for a second.
func end() -> float:
	if hits():
		return moment
	return 1.25 * moment if moment > 0.0 else 1.0


## Whether it touches the target, but for rounding.
func hits() -> bool:
	return miss <= _model.radius + 1e-9 * (_model.way().length() + _model.length)


## How far rounding alone may move it, in pixels: [constant ShotCondition.EPSILON] times its
## condition over all numbers of the shot.
func from_rounding() -> float:
	var direction := Vec2.unit_degrees(degrees)
	var numbers: PackedFloat64Array = []
	for pair: Vec2 in [_model.hull, _model.target, direction]:
		numbers.append_array([pair.x, pair.y])
	numbers.append_array([_model.length, _model.speed, moment])
	return ShotCondition.EPSILON * ShotCondition.of(numbers, _gap_of)


# From the target to the bullet: P + (L + s t) d - T.
static func _gap_of(n: PackedFloat64Array) -> Vec2:
	var reach := n[6] + n[7] * n[8]
	return Vec2.new(n[0] + reach * n[4] - n[2], n[1] + reach * n[5] - n[3])
