class_name AimAtReadout
extends RefCounted
## Shows in the readout the direction to the target, by its angle and by the vector itself, how far
## each is from the exact one, and how long each takes.

var _readout: Readout
var _nanoseconds: Dictionary[String, float] = {}


## Writes into [param readout].
func _init(readout: Readout) -> void:
	_readout = readout


## Measures the run time of both.
func measure(model: AimAtModel) -> void:
	_nanoseconds["angle"] = CallTimer.nanoseconds(_by_angle.bind(model))
	_nanoseconds["vector"] = CallTimer.nanoseconds(_by_vector.bind(model))


## Shows both, from the step with the direction on; none where there is no direction.
func show_model(model: AimAtModel, step: int) -> void:
	var has_direction := model.shot_case() != AimAtModel.Case.NO_DIRECTION
	_readout.visible = step >= AimAtModel.Step.LOOK and has_direction
	_show_call("angle", tr("d by its angle"), _by_angle(model), model)
	_show_call("vector", tr("d as a vector"), _by_vector(model), model)


func _show_call(key: String, title: String, direction: Vec2, model: AimAtModel) -> void:
	var error := _error_of(direction, model) if _readout.visible else 0.0
	_readout.show_vector(key, title, direction, error, _nanoseconds[key])


static func _by_angle(model: AimAtModel) -> Vec2:
	return Vec2.unit_radians(Turn.toward(model.hull, model.target))


static func _by_vector(model: AimAtModel) -> Vec2:
	return model.target.minus(model.hull).normalized()


# How far the direction is from the exact one, which has about 30 digits.
static func _error_of(direction: Vec2, model: AimAtModel) -> float:
	var way := ExactVector.between(model.hull, model.target)
	var length := way.dot(way).square_root()
	var off_x := way.x.divided(length).error_of(direction.x)
	var off_y := way.y.divided(length).error_of(direction.y)
	return Vec2.new(off_x, off_y).length()
