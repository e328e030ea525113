class_name MovingPlatformsDrawing
extends Node2D
## The drawing of the lesson on surfaces that move: the surface with its ball, the velocities at the
## impact tip to tail, the disc that slips, the way of the ball in the press, and the verdict.

# A way that is curved is drawn with so many pieces.
const _PIECES := 120
# Arrows along one line are drawn side by side, so far apart, in pixels of the screen.
const _APART := 11.0
# The arrow of friction is so long, in pixels.
const _FRICTION := 80.0
# The normal is so long, in pixels of the screen.
const _NORMAL := 60.0
# In the diagram of the press a second is so high, in pixels, and so far below the walls.
const _SECOND := 60.0
const _BELOW := 80.0
# Bounces behind this one are too near to each other to be seen.
const _MOST_BOUNCES := 60
# What lies farther away than so many times what is given is not kept in view.
const _FARTHEST := 1.3

@onready var _ball_way: FlightPath = %BallWay
@onready var _zigzag: FlightPath = %Zigzag
@onready var _wall_way: FlightPath = %WallWay
@onready var _far_way: FlightPath = %FarWay
@onready var _surface: SurfaceView = %Surface
@onready var _far_wall: SurfaceView = %FarWall
@onready var _surface_then: SurfaceView = %SurfaceThen
@onready var _ball_then: BallView = %BallThen
@onready var _ball: TurnedBall = %ShownBall
@onready var _wrong_ball: BallView = %WrongBall
@onready var _dot: BallView = %Dot
@onready var _velocity: Arrow = %Velocity
@onready var _surface_velocity: Arrow = %SurfaceVelocity
@onready var _arm: Arrow = %Arm
@onready var _coming: Arrow = %Coming
@onready var _subtracted: Arrow = %Subtracted
@onready var _seen: Arrow = %Seen
@onready var _normal: Arrow = %Normal
@onready var _bounced: Arrow = %Bounced
@onready var _added: Arrow = %Added
@onready var _leaving: Arrow = %Leaving
@onready var _wrong: Arrow = %Wrong
@onready var _friction: Arrow = %Friction
@onready var _verdict: VerdictCard = %Verdict


## Draws [param model] as far as [param step] has got.
func show_model(
	model: MovingPlatformsModel,
	flight: PlatformFlight,
	handles: MovingPlatformsHandles,
	step: MovingPlatformsModel.Step
) -> void:
	_lay_start(model, handles, step)
	_lay_way(model, flight, step)
	_lay_impact(model, flight, step)
	_lay_carried(model, flight, step)
	_lay_diagram(model, flight, step)
	_show_verdict(model, flight, step)


## Shows ball and surface where they are after [param seconds].
func show_moment(
	model: MovingPlatformsModel,
	flight: PlatformFlight,
	seconds: float,
	step: MovingPlatformsModel.Step
) -> void:
	_lay_surface(_surface, flight, flight.surface_at(seconds), seconds)
	_surface.is_belt = model.is_carried()
	_surface.run = model.surface_speed * seconds if model.kind == MovingSurface.Kind.BELT else 0.0
	_lay_surface(_far_wall, flight, model.far_wall(), seconds)
	_far_wall.visible = model.kind == MovingSurface.Kind.PRESS
	var place := flight.ball_at(seconds)
	_ball.lay(flight.seen(place, seconds), MovingSurface.RADIUS)
	_ball.turn = flight.turn_at(seconds)
	if model.from_surface and model.kind == MovingSurface.Kind.PADDLE:
		_ball.turn -= model.turning * seconds
	_ball.role = Palette.Role.WRONG if flight.is_crushed(seconds) else Palette.Role.A
	_ball.label = LabText.translate("t = %s s") % NumberText.short(seconds, 3) if seconds else ""
	_dot.visible = _zigzag.visible
	_dot.lay(_in_diagram(flight, place, seconds), 4.0 / _dot.board.pixels_per_unit)
	_lay_wrong_ball(model, flight, seconds, step)


## What the board must hold, in units of the plane.
func points_to_show(model: MovingPlatformsModel, handles: MovingPlatformsHandles) -> Array[Vec2]:
	var surface := model.first_surface()
	var points: Array[Vec2] = [model.place_at(0.0), surface.start, surface.end]
	var seconds := model.arrow_seconds()
	points.append(points[0].plus(model.first_velocity().scaled(seconds)))
	var moved := handles.first_surface_velocity().scaled(seconds)
	points.append(handles.surface_tail().plus(moved))
	var most := 1.0
	for point in points:
		most = maxf(most, _FARTHEST * point.length())
	var others: Array[Vec2] = []
	match model.kind:
		MovingSurface.Kind.PRESS:
			others = [model.far_wall().end, _in_press(model, 0.0, 0.0)]
			others.append(_in_press(model, 0.0, _diagram_end(model)))
		MovingSurface.Kind.PLATFORM:
			others.append(surface.end.plus(Vec2.new(model.way, 0.0)))
			var slip := Vec2.new(model.run().slip * seconds, 0.0)
			others.append(model.place_at(model.turn_time()).plus(slip))
			others.append(Vec2.new(0.0, -3.0 * MovingSurface.RADIUS))
		_:
			if model.is_impact() and model.impact().hit:
				var met := model.impact()
				others = [met.center, met.center.plus(met.leaving.scaled(seconds))]
				others.append(met.center.plus(met.bounced.scaled(seconds)))
				others.append(met.center.minus(met.seen.scaled(seconds)))
	for other in others:
		other.limit_length(most)
		points.append(other)
	return points


## Where v before the impact ends, drawn from the ball there; null where nothing meets.
func head_before(model: MovingPlatformsModel, flight: PlatformFlight) -> Vec2:
	return _head(model, flight, model.impact().coming) if _has_impact(model) else null


## The same for v′ after it.
func head_after(model: MovingPlatformsModel, flight: PlatformFlight) -> Vec2:
	return _head(model, flight, model.impact().leaving) if _has_impact(model) else null


static func _has_impact(model: MovingPlatformsModel) -> bool:
	return model.is_impact() and model.impact().hit


static func _head(model: MovingPlatformsModel, flight: PlatformFlight, velocity: Vec2) -> Vec2:
	var met := model.impact()
	var arrow := velocity.scaled(model.arrow_seconds())
	return flight.seen(met.center, met.time).plus(flight.seen_direction(arrow, met.time))


static func _lay_surface(
	view: SurfaceView, flight: PlatformFlight, surface: LineSegment, seconds: float
) -> void:
	view.lay(flight.seen(surface.start, seconds), flight.seen(surface.end, seconds))


# The arrows that can be dragged; they make room for what is shown at the impact.
func _lay_start(
	model: MovingPlatformsModel, handles: MovingPlatformsHandles, step: MovingPlatformsModel.Step
) -> void:
	var seconds := model.arrow_seconds()
	var tail := handles.velocity_tail()
	_velocity.lay(tail, tail.plus(model.first_velocity().scaled(seconds)))
	_velocity.visible = model.kind != MovingSurface.Kind.PLATFORM
	_velocity.label = _names(model)[0]
	# Later the same arrow is drawn at the impact, and others beside it.
	if not model.is_carried() and step > MovingPlatformsModel.Step.WATCH:
		_velocity.label = ""
	_velocity.keep_label_from(tail.minus(model.up()))
	var foot := handles.surface_tail()
	var moved := handles.first_surface_velocity().scaled(seconds)
	_surface_velocity.lay(foot, foot.plus(moved))
	_surface_velocity.label = ["w", "s", "V", "", "V"][model.kind]
	_arm.visible = false
	_surface.visible = true
	_verdict.visible = step >= MovingPlatformsModel.Step.BACK


func _lay_way(
	model: MovingPlatformsModel, flight: PlatformFlight, step: MovingPlatformsModel.Step
) -> void:
	_ball_way.visible = model.is_impact()
	if not _ball_way.visible:
		return
	var place := func(seconds: float) -> Vec2: return flight.seen(model.place_at(seconds), seconds)
	var last := flight.end(step)
	_ball_way.show_path(FlightPath.places_every(last / _PIECES, last, place))


# The velocities at an impact, tip to tail: before it v = w + U, after it U′ + w = v′.
func _lay_impact(
	model: MovingPlatformsModel, flight: PlatformFlight, step: MovingPlatformsModel.Step
) -> void:
	var met := model.impact()
	var is_shown := met != null and met.hit and step >= MovingPlatformsModel.Step.FRAME
	# Then the press shows all of its bounces.
	if model.kind == MovingSurface.Kind.PRESS and step >= MovingPlatformsModel.Step.BACK:
		is_shown = false
	for part: Node2D in [_coming, _subtracted, _seen, _normal, _bounced, _added, _leaving]:
		part.visible = false
	_wrong.visible = false
	_surface_then.visible = is_shown
	_ball_then.visible = is_shown
	if not is_shown:
		return
	_coming.label = _names(model)[0]
	_subtracted.label = _names(model)[1]
	_lay_surface(_surface_then, flight, flight.surface_at(met.time), met.time)
	var center := flight.seen(met.center, met.time)
	_ball_then.lay(center, MovingSurface.RADIUS)
	_lay_arm(model, flight, step)
	_lay_before(model, flight, center, step)
	_lay_after(model, flight, center, step)


# Of the velocities of ball and surface.
static func _names(model: MovingPlatformsModel) -> PackedStringArray:
	return ["u₀", "V"] if model.kind == MovingSurface.Kind.PRESS else ["v", "w"]


func _lay_arm(
	model: MovingPlatformsModel, flight: PlatformFlight, step: MovingPlatformsModel.Step
) -> void:
	var met := model.impact()
	_arm.visible = (
		model.kind == MovingSurface.Kind.PADDLE and step == MovingPlatformsModel.Step.FRAME
	)
	var touched := model.surface_start.plus(met.arm)
	_arm.lay(model.surface_start, flight.seen(touched, met.time))
	_arm.keep_label_from(flight.seen(met.center, met.time))


# From where an arrow of these places is drawn: what lies along one line, side by side.
func _beside(met: SurfaceImpact, rows: float) -> Vec2:
	var is_along := (
		absf(met.coming.cross(met.touched)) <= 0.05 * met.coming.length() * met.touched.length()
	)
	if not is_along or met.coming.length() == 0.0:
		return Vec2.new()
	return met.coming.normalized().normal().scaled(rows * _APART / _seen.board.pixels_per_unit)


func _lay_before(
	model: MovingPlatformsModel,
	flight: PlatformFlight,
	center: Vec2,
	step: MovingPlatformsModel.Step
) -> void:
	var met := model.impact()
	var coming := _arrow_then(model, flight, met.coming)
	var seen := _arrow_then(model, flight, met.seen)
	var upper := center.plus(_beside(met, 1.0))
	var lower := center.minus(_beside(met, 1.0))
	_coming.lay(upper.minus(coming), upper)
	_subtracted.lay(upper.minus(coming), upper.minus(seen))
	_seen.lay(lower.minus(seen), lower)
	_seen.label = "U"
	_coming.keep_label_from(center.minus(seen))
	_seen.keep_label_from(center.minus(coming).plus(_beside(met, 4.0)))
	_coming.visible = step in [MovingPlatformsModel.Step.FRAME, MovingPlatformsModel.Step.FLY]
	_subtracted.visible = (step == MovingPlatformsModel.Step.FRAME and met.touched.length() > 0.0)
	_seen.visible = step in [MovingPlatformsModel.Step.FRAME, MovingPlatformsModel.Step.LAW]


func _lay_after(
	model: MovingPlatformsModel,
	flight: PlatformFlight,
	center: Vec2,
	step: MovingPlatformsModel.Step
) -> void:
	var met := model.impact()
	var bounced := _arrow_then(model, flight, met.bounced)
	var leaving := _arrow_then(model, flight, met.leaving)
	var upper := center.plus(_beside(met, 1.0))
	var lower := center.minus(_beside(met, 1.0))
	_bounced.lay(lower, lower.plus(bounced))
	_added.lay(lower.plus(bounced), lower.plus(leaving))
	_leaving.lay(upper, upper.plus(leaving))
	_bounced.keep_label_from(center.plus(leaving).plus(_beside(met, 4.0)))
	_added.keep_label_from(center)
	_leaving.keep_label_from(center.plus(bounced).minus(_beside(met, 4.0)))
	_bounced.visible = step in [MovingPlatformsModel.Step.LAW, MovingPlatformsModel.Step.BACK]
	_added.visible = step == MovingPlatformsModel.Step.BACK and met.touched.length() > 0.0
	_leaving.visible = step >= MovingPlatformsModel.Step.BACK
	var unit := flight.seen_direction(met.normal, met.time)
	_normal.lay(center, center.plus(unit.scaled(_NORMAL / _normal.board.pixels_per_unit)))
	_normal.visible = step == MovingPlatformsModel.Step.LAW
	_normal.label = "n" if model.is_impact() else ""
	if _normal.visible:
		_lay_law(model, flight, center)
	_wrong.visible = _leaving.visible and model.is_impact() and model.mistake_shows()
	if _wrong.visible:
		var lowest := center.minus(_beside(met, 3.0))
		_wrong.lay(lowest, lowest.plus(_arrow_then(model, flight, model.wrong_velocity())))


# U and U′ on both sides of the normal.
func _lay_law(model: MovingPlatformsModel, flight: PlatformFlight, center: Vec2) -> void:
	var met := model.impact()
	var upper := center.plus(_beside(met, 1.0))
	_seen.lay(upper.minus(_arrow_then(model, flight, met.seen)), upper)
	_seen.keep_label_from(_normal_point(met, flight, center).minus(_beside(met, 3.0)))
	_bounced.keep_label_from(_normal_point(met, flight, center).plus(_beside(met, 3.0)))


static func _normal_point(met: SurfaceImpact, flight: PlatformFlight, center: Vec2) -> Vec2:
	return center.plus(flight.seen_direction(met.normal, met.time))


static func _arrow_then(
	model: MovingPlatformsModel, flight: PlatformFlight, velocity: Vec2
) -> Vec2:
	return flight.seen_direction(velocity.scaled(model.arrow_seconds()), model.impact().time)


# The disc on a belt or platform when it begins to slip, and when it rolls.
func _lay_carried(
	model: MovingPlatformsModel, flight: PlatformFlight, step: MovingPlatformsModel.Step
) -> void:
	_friction.visible = false
	if not model.is_carried():
		return
	var run := model.run()
	var begin := model.turn_time() if model.kind == MovingSurface.Kind.PLATFORM else 0.0
	var center := flight.seen(model.place_at(begin), begin)
	var foot := center.minus(model.up().scaled(MovingSurface.RADIUS))
	var along := model.along()
	_seen.lay(foot, foot.plus(along.scaled(run.slip * model.arrow_seconds())))
	_seen.keep_label_from(center)
	_seen.label = "u"
	_seen.visible = step == MovingPlatformsModel.Step.FRAME
	var pull := -signf(run.slip) * _FRICTION / _friction.board.pixels_per_unit
	_friction.lay(foot, foot.plus(along.scaled(pull)))
	_friction.keep_label_from(foot.minus(model.up()))
	_friction.visible = step == MovingPlatformsModel.Step.LAW and model.friction > 0.0
	_friction.visible = _friction.visible and run.slip != 0.0
	var is_platform := model.kind == MovingSurface.Kind.PLATFORM
	_ball_then.visible = is_platform and step >= MovingPlatformsModel.Step.FRAME
	_surface_then.visible = _ball_then.visible
	_ball_then.lay(center, MovingSurface.RADIUS)
	_lay_surface(_surface_then, flight, flight.surface_at(begin), begin)
	if step >= MovingPlatformsModel.Step.BACK and run.rolls():
		_lay_rolling(model, flight, begin + run.roll_time)


func _lay_rolling(model: MovingPlatformsModel, flight: PlatformFlight, moment: float) -> void:
	var center := flight.seen(model.place_at(moment), moment)
	_ball_then.visible = true
	_ball_then.lay(center, MovingSurface.RADIUS)
	_lay_surface(_surface_then, flight, flight.surface_at(moment), moment)
	var rolling := model.along().scaled(model.rolling_speed() * model.arrow_seconds())
	_leaving.lay(center, center.plus(rolling))
	_leaving.keep_label_from(center.minus(model.up()))
	_leaving.visible = true


# Place across, time downwards: the ball between both walls of the press.
func _lay_diagram(
	model: MovingPlatformsModel, flight: PlatformFlight, step: MovingPlatformsModel.Step
) -> void:
	var is_shown := (
		model.kind == MovingSurface.Kind.PRESS and step >= MovingPlatformsModel.Step.BACK
	)
	for part: Node2D in [_zigzag, _wall_way, _far_way]:
		part.visible = is_shown
	if not is_shown:
		return
	var last := model.crush_time()
	var wall: Array[Vec2] = []
	var far: Array[Vec2] = []
	for seconds: float in [0.0, last]:
		var x := -0.5 * model.way + model.surface_speed * seconds
		wall.append(_in_diagram(flight, Vec2.new(x, 0.0), seconds))
		far.append(_in_diagram(flight, Vec2.new(0.5 * model.way, 0.0), seconds))
	_wall_way.show_path(wall)
	_far_way.show_path(far)
	var corners: Array[Vec2] = [wall[0]]
	for bounce: int in _MOST_BOUNCES:
		var before := model.press_time(bounce)
		var speed := Press.speed_after(bounce, model.speed, model.surface_speed)
		var left := Press.way_after(bounce, model.way, model.speed, model.surface_speed)
		for moment: float in [before + left / speed, model.press_time(bounce + 1.0)]:
			corners.append(_in_diagram(flight, model.place_at(moment), moment))
	_zigzag.show_path(corners)


func _in_diagram(flight: PlatformFlight, place: Vec2, seconds: float) -> Vec2:
	var seen := flight.seen(place, seconds)
	return Vec2.new(seen.x, _BELOW + _SECOND * seconds)


static func _in_press(model: MovingPlatformsModel, x: float, seconds: float) -> Vec2:
	return Vec2.new(x, _BELOW + _SECOND * minf(seconds, model.crush_time()))


static func _diagram_end(model: MovingPlatformsModel) -> float:
	return model.crush_time()


func _lay_wrong_ball(
	model: MovingPlatformsModel,
	flight: PlatformFlight,
	seconds: float,
	step: MovingPlatformsModel.Step
) -> void:
	_wrong_ball.visible = (
		step >= MovingPlatformsModel.Step.BACK
		and model.mistake_shows()
		and model.kind != MovingSurface.Kind.PRESS
	)
	if not _wrong_ball.visible:
		return
	var place := flight.ball_at(seconds)
	if model.is_impact() and seconds > model.impact().time:
		var since := seconds - model.impact().time
		place = model.impact().center.plus(model.wrong_velocity().scaled(since))
	elif model.mistake == MovingPlatformsMistakes.FRAME_LATE:
		place = model.place_at(maxf(seconds - MovingPlatformsMistakes.FRAME, 0.0))
	elif model.is_carried():
		var begin := model.turn_time() if model.kind == MovingSurface.Kind.PLATFORM else 0.0
		var since := seconds - begin - model.run().roll_time
		if since > 0.0:
			place = model.place_at(seconds - since)
			place.add(model.along().scaled(model.wrong_speed() * since))
	_wrong_ball.lay(flight.seen(place, seconds), MovingSurface.RADIUS)


# The card gives way to what can be dragged and to what is shown at the impact.
func _show_verdict(
	model: MovingPlatformsModel, flight: PlatformFlight, step: MovingPlatformsModel.Step
) -> void:
	if not _verdict.visible:
		return
	var sign_text := MovingPlatformsTexts.verdict_sign(model)
	var role := Palette.Role.RIGHT
	if sign_text == "✗":
		role = Palette.Role.WRONG
	elif sign_text == "0":
		role = Palette.Role.QUIET
	_verdict.show_verdict(sign_text, role, MovingPlatformsTexts.verdict(model, flight, step))
	var board := _ball.board
	var places: PackedVector2Array = []
	for part: Arrow in [_velocity, _surface_velocity, _coming, _bounced, _leaving, _wrong]:
		if part.visible:
			for point in part.spanned_points():
				places.append(board.to_screen(point))
	for part: SurfaceView in [_surface, _surface_then, _far_wall]:
		for point in part.spanned_points():
			places.append(board.to_screen(point))
	for part: BallView in [_ball, _ball_then]:
		for point in part.spanned_points():
			places.append(board.to_screen(point))
	_verdict.keep_off(places, 24.0)
