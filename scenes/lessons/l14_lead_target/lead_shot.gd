class_name LeadShot
extends RefCounted
## A bullet that is fired in some direction: where it is nearest to the target, and by how much it
## misses, flown in the event world.

## The direction in which the shooter aims, of length 1; zero where there is none: nothing is fired.
var direction := Vec2.new()
## The velocity of the bullet on the ground: u + s d, in pixels per second.
var velocity := Vec2.new()
## The moment of the hit, else the one at which it is nearest to the target; in seconds.
var moment := 0.0
## Pixels by which it misses: of a right shot by how much both do not quite touch, of another one
## the smallest distance of the centres.
var miss := 0.0
## Whether it is the right one.
var is_right := false

var _model: LeadTargetModel
var _flight: FiredShot


## The shot of [param model] along [param its_direction].
func _init(model: LeadTargetModel, its_direction: Vec2) -> void:
	_model = model
	direction = its_direction
	velocity = model.own.plus(direction.scaled(model.speed))
	_flight = FiredShot.new(model.shooter, velocity)


## The right shot, nothing where there is none that can be flown.
static func right(model: LeadTargetModel) -> LeadShot:
	if not model.can_fly():
		return LeadShot.new(model, Vec2.new())
	var aim := model.aim()
	var shot := LeadShot.new(model, aim.direction)
	shot.is_right = true
	shot.moment = aim.time
	shot.miss = absf(shot.distance_after(aim.time) - model.radius)
	if aim.time == 0.0:
		shot.miss = 0.0
	return shot


## A shot along [param its_direction], which need not hit.
static func along(model: LeadTargetModel, its_direction: Vec2) -> LeadShot:
	var shot := LeadShot.new(model, its_direction)
	# The bullet as the target sees it: it rests, as far from the muzzle as it was. So a miss far from
	# the origin, or of a target that is quickly far away, keeps its digits.
	var relative := shot.velocity.minus(model.velocity)
	var nearest := model.way().dot(relative) / relative.length_squared()
	if relative.length() == 0.0 or is_nan(nearest):
		nearest = 0.0
	shot.moment = clampf(nearest, 0.0, LeadTargetModel.LONGEST_FLIGHT)
	var seen := FiredShot.new(Vec2.new(), relative)
	shot.miss = seen.place_after(shot.moment).distance_to(model.way())
	return shot


## Whether anything is fired.
func is_fired() -> bool:
	return direction.length() > 0.0


## Whether the discs of bullet and target touch somewhere on the way, but for rounding.
func touches() -> bool:
	var scale := _model.way().length() + _model.radius
	return is_right or is_fired() and miss <= _model.radius + 1e-9 * scale


## Where the bullet is after [param seconds], in pixels. After its hit a right one stays in the
## target.
func place_after(seconds: float) -> Vec2:
	if is_right and seconds > moment:
		var in_target := direction.scaled(_model.radius)
		return _model.target_after(seconds, false).minus(in_target)
	return _flight.place_after(seconds)


## How far both centres are from each other after [param seconds], in pixels.
func distance_after(seconds: float) -> float:
	return _flight.distance_after(seconds, _model.aim_target().position_after)


## When its flight has been seen: at the hit, or some time after it was nearest; in seconds.
func end() -> float:
	return moment if touches() else 1.25 * moment


## How far rounding alone may move a right shot, in pixels: [constant ShotCondition.EPSILON] times
## its condition over all numbers of the shot.
func from_rounding() -> float:
	var numbers: PackedFloat64Array = []
	for pair: Vec2 in [_model.shooter, _model.target, _model.velocity, _model.own, direction]:
		numbers.append_array([pair.x, pair.y])
	numbers.append_array([_model.speed, _model.radius, moment])
	return ShotCondition.EPSILON * ShotCondition.of(numbers, _gap_of)


# From the target to where the bullet touches it: S + (u + s d) t + R d - T - v t.
static func _gap_of(n: PackedFloat64Array) -> Vec2:
	var time := n[12]
	return Vec2.new(
		n[0] + (n[6] + n[10] * n[8]) * time + n[11] * n[8] - n[2] - n[4] * time,
		n[1] + (n[7] + n[10] * n[9]) * time + n[11] * n[9] - n[3] - n[5] * time
	)
