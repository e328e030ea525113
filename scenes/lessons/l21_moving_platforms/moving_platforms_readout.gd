class_name MovingPlatformsReadout
extends RefCounted
## Shows in the readout the velocity that comes out, with its error against the exact one and the
## run time of the call; of a press when the ball is crushed.

var _readout: Readout
var _nanoseconds := 0.0


## Writes into [param readout].
func _init(readout: Readout) -> void:
	_readout = readout


## Measures the run time of the call.
func measure(model: MovingPlatformsModel) -> void:
	_nanoseconds = CallTimer.nanoseconds(_call(model))


## Shows what [param model] comes to, from the last step on.
func show_model(model: MovingPlatformsModel, step: MovingPlatformsModel.Step) -> void:
	_readout.visible = step == MovingPlatformsModel.Step.FLY
	if model.is_carried():
		_show_rolling(model)
	elif model.kind == MovingSurface.Kind.PRESS:
		_show_crush(model)
	else:
		_show_velocity(model)


func _show_velocity(model: MovingPlatformsModel) -> void:
	var met := model.impact()
	if not met.hit:
		_show("v′", LabText.translate("none"), "")
		return
	var size := met.coming.length() + 2.0 * met.touched.length()
	# Where a turning paddle is met has no exact answer here, nor has an end of the wall.
	var error := ""
	var along := model.first_surface().along()
	var is_line := absf(met.normal.dot(along)) <= 1e-6 * along.length()
	if model.kind == MovingSurface.Kind.WALL and is_line:
		error = NumberText.size(
			PlatformExact.error_of_velocity(
				met.leaving, model.velocity, model.surface_velocity, along, model.bounciness
			)
		)
	_show("v′", MovingPlatformsTexts.pair(met.leaving, size), error)


func _show_rolling(model: MovingPlatformsModel) -> void:
	if not model.run().rolls():
		_show("v′", LabText.translate("none"), "")
		return
	var is_platform := model.kind == MovingSurface.Kind.PLATFORM
	var speed := model.surface_speed if is_platform else model.speed
	var surface_speed := -model.surface_speed if is_platform else model.surface_speed
	var rolling := model.rolling_speed()
	var error := ""
	if model.run().pull() == 0.0:
		error = NumberText.size(PlatformExact.error_of_rolling(rolling, speed, surface_speed))
	_show("v′", MovingPlatformsTexts.speed_text(model), error)


func _show_crush(model: MovingPlatformsModel) -> void:
	var seconds := model.crush_time()
	var error := PlatformExact.error_of_quotient(seconds, model.way, model.surface_speed)
	_show(LabText.translate("crushed after"), NumberText.short(seconds), NumberText.size(error))


func _show(title: String, value: String, error: String) -> void:
	_readout.show_texts("answer", [title, value, error, _readout.time_text(_nanoseconds)])


static func _call(model: MovingPlatformsModel) -> Callable:
	if model.is_carried():
		var incline := model.incline()
		var distance := model.distance()
		return func() -> InclineRun:
			return incline.run(MovingSurface.RADIUS, distance, model.speed, 0.0, 1.0)
	if model.kind == MovingSurface.Kind.PRESS:
		return Press.at.bind(0.5 * model.crush_time(), model.way, model.speed, model.surface_speed)
	return SurfaceImpact.of.bind(model.first_ball(), model.moving(), model.bounciness)
