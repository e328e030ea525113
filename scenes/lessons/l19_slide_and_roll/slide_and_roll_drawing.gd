class_name SlideAndRollDrawing
extends Node2D
## The drawing of the lesson on sliding and rolling: the line with its ball and what acts on it, the
## two lines beside it on which others race, and the verdict.

# Beside the line of the ball, one on each side, are those of the others: so far, in radii and as a
# share of the line.
const _LANE_IN_RADII := 3.6
const _LANE_OF_LINE := 0.12
# The arrow of gravity is so long, in radii and as a share of the line.
const _GRAVITY_IN_RADII := 5.0
const _GRAVITY_OF_LINE := 0.1
# The handle of the speed is so many radii before the ball's centre, and for each px/s so much
# farther.
const _SPEED_IN_RADII := 2.6
const _SPEED_SCALE := 0.2
# A speed that is dragged is a multiple of this, in px/s.
const _SPEED_STEP := 10.0

@onready var _card: FrictionCard = %Card
@onready var _curve: FrictionCurve = %Curve
@onready var _line: DraggableVector = %Line
@onready var _slide_line: Arrow = %SlideLine
@onready var _roll_line: Arrow = %RollLine
@onready var _finish: Arrow = %Finish
@onready var _gravity: Arrow = %Gravity
@onready var _pull: Arrow = %Pull
@onready var _pressure: Arrow = %Pressure
@onready var _friction: Arrow = %Friction
@onready var _stem: Arrow = %Stem
@onready var _speed_handle: Handle = %SpeedHandle
@onready var _ball: TurnedBall = %Ball
@onready var _slide_ball: TurnedBall = %SlideBall
@onready var _roll_ball: TurnedBall = %RollBall
@onready var _wrong_ball: BallView = %WrongBall
@onready var _engine: EngineRunner = %Engine
@onready var _verdict: VerdictCard = %Verdict


## Draws [param model] with the balls of [param race] as far as [param step] has got.
func show_model(model: SlideAndRollModel, race: BallRace, step: int) -> void:
	_line.lay(model.start, model.end)
	_lay_lanes(model, step)
	_lay_speed(model, step)
	_card.visible = step >= SlideAndRollModel.Step.SLIP
	var has_wrong_mark := (
		SlideAndRollTexts.is_compared(model, step)
		and model.mistake == SlideAndRollMistakes.THRESHOLD
	)
	var farthest := model.slope() if has_wrong_mark else model.mark()
	_card.show_friction(model.friction, model.mark(), farthest)
	_curve.visible = step >= SlideAndRollModel.Step.MARK
	_curve.show_model(model, has_wrong_mark)
	show_moment(model, race, step)
	_show_verdict(model, race, step)


## Shows the balls where they are now.
func show_moment(model: SlideAndRollModel, race: BallRace, step: int) -> void:
	var is_race := step >= SlideAndRollModel.Step.RACE
	var shown := race.shown_ball(step)
	_lay_ball(_ball, model, shown, Vec2.new())
	_ball.label = _label(model, step)
	_lay_ball(_slide_ball, model, race.sliding, _lane(model))
	_lay_ball(_roll_ball, model, race.rolling, _lane(model).negated())
	_slide_ball.visible = is_race
	_roll_ball.visible = is_race
	_lay_forces(model, shown, step)
	_lay_wrong(model, race, step)
	_engine.show_moment(model.time, _ball.at())
	_engine.visible = step >= SlideAndRollModel.Step.SLIP


## The speed at the start for a handle at [param knob], in px/s: a round number, not below 0.
func speed_for(model: SlideAndRollModel, knob: Vec2) -> float:
	var along := model.segment().along()
	var before := knob.minus(model.center_at(0.0)).scalar_projection(along)
	var wanted := (before - _SPEED_IN_RADII * model.radius) / _SPEED_SCALE
	return clampf(snappedf(wanted, _SPEED_STEP), 0.0, SlideAndRollModel.LARGEST)


## What the board has to show at [param step]: the line, from the race on all three, with their
## balls, and all that can be dragged.
func points_to_show(model: SlideAndRollModel, step: int) -> Array[Vec2]:
	var lane := _lane(model) if step >= SlideAndRollModel.Step.RACE else Vec2.new()
	var top := model.up().scaled(2.0 * model.radius)
	var points: Array[Vec2] = [_speed_point(model)]
	for end: Vec2 in [model.start, model.end]:
		points.append(end.plus(lane).plus(top))
		points.append(end.minus(lane))
	return points


# From the line of the ball to that of the ball without friction.
func _lane(model: SlideAndRollModel) -> Vec2:
	var length := model.segment().length()
	var width := maxf(_LANE_IN_RADII * model.radius, _LANE_OF_LINE * length)
	return model.up().scaled(width)


func _lay_lanes(model: SlideAndRollModel, step: int) -> void:
	var lane := _lane(model)
	_slide_line.lay(model.start.plus(lane), model.end.plus(lane))
	_roll_line.lay(model.start.minus(lane), model.end.minus(lane))
	var top := model.up().scaled(2.0 * model.radius)
	_finish.lay(model.end.minus(lane), model.end.plus(lane).plus(top))
	for part: Arrow in [_slide_line, _roll_line, _finish]:
		part.visible = step >= SlideAndRollModel.Step.RACE


# Where forces are drawn there is no room for it.
func _lay_speed(model: SlideAndRollModel, step: int) -> void:
	var along := model.segment().along().normalized()
	var center := model.center_at(0.0)
	_stem.lay(center.plus(along.scaled(model.radius)), _speed_point(model))
	_stem.keep_label_from(model.start)
	_speed_handle.place(_speed_point(model))
	_stem.visible = not _shows_forces(step)
	_speed_handle.visible = not _shows_forces(step)


func _speed_point(model: SlideAndRollModel) -> Vec2:
	var along := model.segment().along().normalized()
	var reach := _SPEED_IN_RADII * model.radius + _SPEED_SCALE * model.speed
	return model.center_at(0.0).plus(along.scaled(reach))


func _lay_ball(view: TurnedBall, model: SlideAndRollModel, racer: RacingBall, lane: Vec2) -> void:
	view.lay(model.center_at(racer.after(model.time).distance).plus(lane), model.radius)
	view.turn = racer.turn_after(model.time)


func _label(model: SlideAndRollModel, step: int) -> String:
	var parts: PackedStringArray = []
	if step >= SlideAndRollModel.Step.RACE:
		parts.append("µ = %s" % NumberText.short(model.friction))
	if model.time > 0.0:
		parts.append("t = %s s" % NumberText.short(model.time, 3))
	return "   ".join(parts)


static func _shows_forces(step: int) -> bool:
	return step >= SlideAndRollModel.Step.PULL and step < SlideAndRollModel.Step.RACE


# What acts on the ball: gravity with its two parts, and friction against the slip.
func _lay_forces(model: SlideAndRollModel, shown: RacingBall, step: int) -> void:
	var incline := model.incline(model.friction)
	var length := incline.length
	var longest := maxf(_GRAVITY_IN_RADII * model.radius, _GRAVITY_OF_LINE * length)
	var scale_of_forces := longest / model.gravity
	var along := model.segment().along().normalized()
	var center := _ball.at()
	var is_shown := _shows_forces(step)
	_lay_force(
		_gravity, center, Vec2.new(0.0, longest), is_shown and step == SlideAndRollModel.Step.PULL
	)
	_lay_force(_pull, center, along.scaled(incline.pull * scale_of_forces), is_shown)
	var pressed := model.up().scaled(-incline.pressure * scale_of_forces)
	_lay_force(_pressure, center, pressed, is_shown and step <= SlideAndRollModel.Step.MARK)
	var rubs := _friction_at(model, shown, incline) * scale_of_forces
	var foot := center.minus(model.up().scaled(model.radius))
	_lay_force(
		_friction, foot, along.scaled(-rubs), is_shown and step >= SlideAndRollModel.Step.SLIP
	)


static func _lay_force(arrow: Arrow, from: Vec2, force: Vec2, is_shown: bool) -> void:
	arrow.lay(from, from.plus(force))
	arrow.visible = is_shown and force.length() > 0.0


# Friction per mass, in px/s², as it is now.
static func _friction_at(model: SlideAndRollModel, shown: RacingBall, incline: Incline) -> float:
	if shown.roll_time >= 0.0 and model.time >= shown.roll_time:
		return incline.pull / Friction.YIELD
	if model.height() == 0.0 and model.speed == 0.0:
		return 0.0
	return model.friction * incline.pressure


func _lay_wrong(model: SlideAndRollModel, race: BallRace, step: int) -> void:
	_wrong_ball.visible = SlideAndRollTexts.is_compared(model, step) and model.shows_mistake()
	if not race.wrong:
		return
	var length := model.segment().length()
	var distance := clampf(race.wrong.distance_after(model.time), 0.0, length)
	_wrong_ball.lay(model.center_at(distance), model.radius)


func _show_verdict(model: SlideAndRollModel, race: BallRace, step: int) -> void:
	_verdict.visible = step >= SlideAndRollModel.Step.ROLL
	var sign_text := "!"
	var role := Palette.Role.PROJECTION
	if race.run_case == SlideAndRollModel.Case.RESTS:
		sign_text = "×"
		role = Palette.Role.QUIET
	if SlideAndRollTexts.is_compared(model, step) and model.shows_mistake():
		sign_text = "✗"
		role = Palette.Role.WRONG
	_verdict.show_verdict(sign_text, role, SlideAndRollTexts.verdict(model, race, step))
	_verdict.keep_off(_taken_places(model, step), 24.0)


func _taken_places(model: SlideAndRollModel, step: int) -> PackedVector2Array:
	var board := _ball.board
	var places: PackedVector2Array = []
	var lane := _lane(model) if step >= SlideAndRollModel.Step.RACE else Vec2.new()
	for share: float in [0.0, 0.25, 0.5, 0.75, 1.0]:
		var center := model.center_at(share * model.segment().length())
		for point: Vec2 in [center.plus(lane), center, center.minus(lane)]:
			places.append(board.to_screen(point))
	if _card.get_parent() == board:
		for share: float in [0.1, 0.5, 0.9]:
			for down: float in [0.0, 0.5, 1.0]:
				places.append(_card.position + _card.size * Vector2(share, down))
	return places
