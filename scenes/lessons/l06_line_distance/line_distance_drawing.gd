class_name LineDistanceDrawing
extends Node2D
## The drawing of the lesson on the distance from a line: difference vector, its shadow on the
## normal, the gap, what the mistake that is switched on makes of it, and the verdict.

@onready var _endless: InfiniteLine = %Endless
@onready var _line: DraggableVector = %Line
@onready var _from: Handle = %From
@onready var _ball: BallView = %Ball
# The same in the colour of the answer.
@onready var _judged_ball: BallView = %JudgedBall
@onready var _ball_handle: BallHandle = %BallHandle
@onready var _names: DistanceNames = %Names
@onready var _difference: Arrow = %Difference
@onready var _normal: Arrow = %Normal
@onready var _shadow: Arrow = %Shadow
@onready var _rejection: Arrow = %Rejection
@onready var _right_angle: AngleArc = %RightAngle
@onready var _gap: DimensionLine = %Gap
@onready var _radius: DimensionLine = %Radius
@onready var _to_segment: DimensionLine = %ToSegment
@onready var _wrong_ball: BallView = %WrongBall
@onready var _wrong_way: DimensionLine = %WrongWay
@onready var _right_way: DimensionLine = %RightWay
@onready var _frames: DetectionFrames = %Frames
@onready var _verdict: VerdictCard = %Verdict


## Draws [param model] as far as [param step], counted from 0, has got.
func show_model(model: LineDistanceModel, step: int) -> void:
	_endless.lay(model.line.start, model.line.along())
	_line.lay(model.line.start, model.line.end)
	_from.place(model.from())
	_lay_ball(model, step)
	_lay_normal(model, step)
	_lay_shadow(model, step)
	_lay_gap(model, step)
	_lay_to_segment(model, step)
	_lay_mistake(model, step)
	show_flight(model, step)
	_names.show_change()
	_show_verdict(model, step)


## Draws the flight of the last step as far as it has got.
func show_flight(model: LineDistanceModel, step: int) -> void:
	_frames.visible = step == LineDistanceTexts.Step.DETECTION
	var centers: Array[Vec2] = []
	var is_red: Array[bool] = []
	for frame: int in model.frame + 1:
		centers.append(model.position_at(frame))
		is_red.append(model.detection().is_red(frame))
	_frames.lay(centers, is_red, model.ball.radius)


func _lay_ball(model: LineDistanceModel, step: int) -> void:
	_ball.lay(model.ball.position, model.ball.radius)
	var is_detected := step == LineDistanceTexts.Step.DETECTION
	_judged_ball.visible = step >= LineDistanceTexts.Step.GAP and not is_detected
	_judged_ball.role = Palette.Role.WRONG if model.is_overlapping() else Palette.Role.RIGHT
	# With a mistake the two distances have their labels there.
	_judged_ball.label = LineDistanceTexts.ball_word(model) if model.mistake == 0 else ""
	_judged_ball.lay(model.ball.position, model.ball.radius)
	_ball_handle.place_ball(model.ball.position, model.ball.radius)
	_difference.lay(model.from(), model.ball.position)
	_difference.keep_label_from(model.foot())
	_difference.visible = not is_detected


func _lay_normal(model: LineDistanceModel, step: int) -> void:
	var drawn := model.line.normal().scaled(_names.times())
	_normal.lay(model.from(), model.from().plus(drawn))
	_normal.visible = step >= LineDistanceTexts.Step.NORMAL


func _lay_shadow(model: LineDistanceModel, step: int) -> void:
	var normal := model.line.normal()
	var corner := model.from().plus(normal.scaled(model.distance()))
	_shadow.lay(model.from(), corner)
	_rejection.lay(corner, model.ball.position)
	var back := normal.scaled(-model.distance())
	_right_angle.measure(corner, back, model.ball.position.minus(corner))
	var is_detected := step == LineDistanceTexts.Step.DETECTION
	_shadow.visible = step >= LineDistanceTexts.Step.DISTANCE and not is_detected
	_rejection.visible = _shadow.visible
	_right_angle.visible = _right_angle.visible and _shadow.visible


func _lay_gap(model: LineDistanceModel, step: int) -> void:
	var away := _away_from_p(model)
	# Where both overlap, the gap is drawn beside the ball.
	var rim_pixels := model.ball.radius * _endless.board.pixels_per_unit
	_gap.offset = 18.0 if model.gap() > 0.0 else rim_pixels + 14.0
	_gap.label = tr("gap %s") % LineDistanceTexts.gap_text(model)
	_gap.lay(model.foot(), model.rim(), away)
	var is_shown := step in [LineDistanceTexts.Step.GAP, LineDistanceTexts.Step.SEGMENT]
	_gap.visible = is_shown and model.mistake == 0
	_radius.label = "r"
	_radius.lay(model.rim(), model.ball.position, away.negated())
	_radius.visible = _gap.visible


func _away_from_p(model: LineDistanceModel) -> Vec2:
	var along := model.line.along()
	return along if model.difference().dot(along) >= 0.0 else along.negated()


func _lay_to_segment(model: LineDistanceModel, step: int) -> void:
	_to_segment.label = tr("segment %s") % NumberText.short(model.segment_distance())
	var outside := model.foot().minus(model.ball.position)
	_to_segment.lay(model.nearest(), model.ball.position, outside)
	_to_segment.visible = step == LineDistanceTexts.Step.SEGMENT and model.is_beside_end()


func _lay_mistake(model: LineDistanceModel, step: int) -> void:
	var place := model.position_with_mistake()
	var is_compared := LineDistanceTexts.is_compared(model, step)
	var is_shown := is_compared and place.is_finite()
	_wrong_ball.visible = is_shown
	_wrong_way.visible = is_shown
	_right_way.visible = is_compared
	_right_way.label = tr("right %s") % NumberText.short(model.distance())
	# Away from p, where d is, unless both ways are on the same side of the line.
	var is_same_side := model.distance() * model.distance_with_mistake() > 0.0
	var away := _away_from_p(model)
	_right_way.lay(model.foot(), model.ball.position, away.negated() if is_same_side else away)
	if not is_shown:
		return
	_wrong_ball.lay(place, model.ball.radius)
	_wrong_way.label = tr("wrong %s") % NumberText.short(model.distance_with_mistake())
	if model.mistake == LineDistanceMistakes.STRAIGHT_UP:
		var below := LineDistanceMistakes.point_straight_below(model.ball.position, model.line)
		_wrong_way.offset = 0.0
		_wrong_way.lay(below, model.ball.position, below.minus(model.foot()))
	else:
		_wrong_way.offset = 14.0
		_wrong_way.lay(model.foot(), place, _away_from_p(model))


# The card gives way to the ball, to where a mistake or its flight has it, and to the line's ends.
func _show_verdict(model: LineDistanceModel, step: int) -> void:
	_verdict.visible = step >= LineDistanceTexts.Step.GAP
	var sign_text := NumberText.MINUS if model.is_behind() else "+"
	var is_red := model.is_overlapping()
	if step == LineDistanceTexts.Step.DETECTION:
		is_red = model.detection().red_count(model.frame) > 0
		sign_text = "!" if is_red else "0"
	_verdict.show_verdict(
		sign_text,
		Palette.Role.WRONG if is_red else Palette.Role.RIGHT,
		LineDistanceTexts.verdict(model, step)
	)
	var board := _endless.board
	var balls: PackedVector2Array = [board.to_screen(model.ball.position)]
	for end: Vec2 in [model.line.start, model.line.end]:
		balls.append(board.to_screen(end))
	if step == LineDistanceTexts.Step.DETECTION:
		balls.append(board.to_screen(model.position_at(model.frame)))
	if _wrong_ball.visible:
		balls.append(board.to_screen(model.position_with_mistake()))
	_verdict.keep_off(balls, model.ball.radius * board.pixels_per_unit)
