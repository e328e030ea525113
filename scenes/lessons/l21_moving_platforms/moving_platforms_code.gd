class_name MovingPlatformsCode
extends RefCounted
## The lines of GDScript that compute what each step of the lesson on surfaces that move shows.

const _SEEN := "var seen := velocity.minus(w)"
const _BOUNCED := "var bounced := seen.reflected(n, bounciness)"
const _LEAVING := "var leaving := bounced.plus(w)"
const _WALL := "FrictionImpact.with_segment(ball, wall, bounciness, 0.0, w)"
const _PADDLE := "FrictionImpact.with_turning(ball, paddle, bounciness, 0.0, 20.0)"


## The lines of [param step]; none where nothing is computed.
static func lines(
	model: MovingPlatformsModel, step: MovingPlatformsModel.Step
) -> PackedStringArray:
	if model.is_carried():
		return _lines_on_carried(model, step)
	if model.kind == MovingSurface.Kind.PRESS:
		return _lines_on_press(step)
	if not model.impact().hit:
		return []
	var is_paddle := model.kind == MovingSurface.Kind.PADDLE
	match step:
		MovingPlatformsModel.Step.FRAME:
			if is_paddle:
				return ["var w := Vec2.new(-arm.y, arm.x).scaled(turning)", _SEEN]
			return [_SEEN]
		MovingPlatformsModel.Step.LAW:
			return [_BOUNCED]
		MovingPlatformsModel.Step.BACK:
			return [_LEAVING]
		MovingPlatformsModel.Step.FLY:
			return ["var leaving := %s.velocity" % (_PADDLE if is_paddle else _WALL)]
	return []


static func _lines_on_carried(
	model: MovingPlatformsModel, step: MovingPlatformsModel.Step
) -> PackedStringArray:
	match step:
		MovingPlatformsModel.Step.FRAME:
			return ["var slip := speed - surface_speed"]
		MovingPlatformsModel.Step.LAW:
			return ["var grip := friction * pressure"]
		MovingPlatformsModel.Step.BACK:
			if model.run().run_case == CarriedRun.Case.ROLLS_LATER and model.run().pull() == 0.0:
				return ["var t := absf(slip) / (3.0 * grip)", "var v := speed - slip / 3.0"]
		MovingPlatformsModel.Step.FLY:
			if model.kind == MovingSurface.Kind.BELT:
				return [
					"var run := belt.run(radius, distance, speed, 0.0, 1.0)", "var v := run.speed"
				]
	return []


static func _lines_on_press(step: MovingPlatformsModel.Step) -> PackedStringArray:
	match step:
		MovingPlatformsModel.Step.FRAME:
			return ["var seen := speed + surface_speed"]
		MovingPlatformsModel.Step.LAW:
			return ["var u1 := speed + 2.0 * surface_speed"]
		MovingPlatformsModel.Step.BACK:
			return [
				"var u3 := Press.speed_after(3.0, speed, surface_speed)",
				"var h3 := Press.way_after(3.0, way, speed, surface_speed)",
			]
		MovingPlatformsModel.Step.FLY:
			return ["var crushed := way / surface_speed"]
	return []


## The values of the names in the lines.
static func inputs(model: MovingPlatformsModel) -> Dictionary[String, Variant]:
	if model.is_carried():
		return _inputs_on_carried(model)
	if model.kind == MovingSurface.Kind.PRESS:
		return {
			"Press": Press,
			"speed": model.speed,
			"surface_speed": model.surface_speed,
			"way": model.way,
		}
	var met := model.impact()
	return {
		"FrictionImpact": FrictionImpact,
		"ball": model.first_ball(),
		"wall": model.first_surface(),
		"paddle": model.moving(),
		"velocity": met.coming,
		"w": met.touched,
		"arm": met.arm,
		"turning": model.turning,
		"n": met.normal,
		"seen": met.seen,
		"bounced": met.bounced,
		"bounciness": model.bounciness,
	}


static func _inputs_on_carried(model: MovingPlatformsModel) -> Dictionary[String, Variant]:
	var run := model.run()
	var is_platform := model.kind == MovingSurface.Kind.PLATFORM
	return {
		"belt": model.incline(),
		"radius": MovingSurface.RADIUS,
		"distance": model.distance(),
		# The platform has turned back.
		"speed": model.surface_speed if is_platform else model.speed,
		"surface_speed": -model.surface_speed if is_platform else model.surface_speed,
		"friction": model.friction,
		"pressure": run.pressure(),
		"grip": run.grip(),
		"slip": run.slip,
	}
