class_name EasyBounceDrawing
extends Node2D
## The drawing of the lesson on the easy bounce, step by step: what the easy program does in a frame
## beside what is right.

# Length, in units, of the dashed line from which the tilt is measured.
const _LEVEL_LENGTH := 110.0

var _model: EasyBounceModel
var _step := 0
var _moved: Ball
# What both programs make of the moved ball, and whether that is the same.
var _easy: Ball
var _right: Ball
var _are_same := true

@onready var _line: DraggableVector = %Line
@onready var _level: Arrow = %Level
@onready var _tilt: AngleArc = %Tilt
@onready var _ball: BallView = %Ball
@onready var _before: BallView = %Before
@onready var _easy_path: FramePath = %EasyPath
@onready var _right_path: FramePath = %RightPath
@onready var _easy_ball: BallView = %EasyBall
@onready var _right_ball: BallView = %RightBall
@onready var _straight: DimensionLine = %Straight
@onready var _shortest: DimensionLine = %Shortest
@onready var _corner: AngleArc = %Corner
@onready var _point_l: Arrow = %PointL
@onready var _from_l: Arrow = %FromL
@onready var _normal: Arrow = %Normal
@onready var _easy_arrow: Arrow = %EasyArrow
@onready var _right_arrow: Arrow = %RightArrow
@onready var _velocity: Arrow = %Velocity


## Draws the frame that [param model] shows, as far as [param step] of [EasyBounceTexts] has got.
func show_model(model: EasyBounceModel, step: int) -> void:
	_model = model
	_step = step
	_moved = model.moved_ball(model.frame())
	_easy = model.easy_result(_moved)
	_right = model.right_result(_moved)
	_are_same = model.is_level()
	_hide_all()
	_lay_line()
	_ball.lay(_moved.position, _moved.radius)
	_velocity.lay(_moved.position, _moved.position.plus(_moved.velocity))
	_velocity.visible = EasyBounceTexts.needs_velocity(step)
	match step:
		EasyBounceTexts.Step.MOVE:
			_show_move()
		EasyBounceTexts.Step.DETECT:
			_show_distances()
		EasyBounceTexts.Step.PUT_BACK:
			_show_put_back()
		EasyBounceTexts.Step.FLIP:
			_show_flip()
		EasyBounceTexts.Step.BOUNCE:
			_show_bounce()


func _hide_all() -> void:
	for part: Node2D in [_before, _easy_path, _right_path, _easy_ball, _right_ball, _straight]:
		part.visible = false
	for part: Node2D in [_shortest, _corner, _normal, _easy_arrow, _right_arrow]:
		part.visible = false
	for part: Node2D in [_point_l, _from_l]:
		part.visible = false


func _lay_line() -> void:
	var line := _model.line()
	_line.lay(line.start, line.end)
	# On the side away from the perpendicular.
	var side := -signf(_model.tilt_degrees)
	var level := Vec2.unit_degrees(90.0 if _model.is_wall else 180.0).scaled(side)
	_level.lay(_model.pivot, _model.pivot.plus(level.scaled(_LEVEL_LENGTH)))
	_tilt.measure(_model.pivot, level, _model.along().scaled(side))
	# Where the difference vector is drawn, the tilt is in its way.
	_level.visible = not _are_same and _step != EasyBounceTexts.Step.DETECT
	_tilt.visible = _level.visible


func _show_move() -> void:
	_before.visible = true
	_before.lay(_moved.position.minus(_moved.velocity), _moved.radius)


func _show_distances() -> void:
	var center := _moved.position
	var foot := _model.shortest_foot(center)
	# The side of the straight line on which the perpendicular lies.
	var beside := Vec2.new(0.0, 1.0) if _model.is_wall else Vec2.new(-1.0, 0.0)
	if _model.tilt_degrees < 0.0:
		beside = beside.negated()
	_shortest.visible = true
	_shortest.label = NumberText.short(_model.shortest_distance(center))
	_shortest.lay(center, foot, beside)
	if _are_same:
		return
	_shortest.label = tr("shortest %s") % _shortest.label
	_straight.visible = true
	_straight.label = tr("easy %s") % NumberText.short(_model.straight_distance(center))
	_straight.lay(center, _model.straight_foot(center), beside.negated())
	_corner.measure(foot, center.minus(foot), _model.along())
	_show_difference(center, foot)


# The vector from a point L of the line: its part along the normal is the shortest distance.
func _show_difference(center: Vec2, foot: Vec2) -> void:
	var start := _model.line().start
	_point_l.visible = true
	_point_l.lay(start, start)
	_from_l.visible = true
	_from_l.lay(start, center)
	_from_l.keep_label_from(foot)


func _show_put_back() -> void:
	if not _model.right_detects(_moved):
		return
	_show_balls(_easy.position, _right.position)
	_right_arrow.visible = true
	_right_arrow.label = "" if _are_same else tr("right")
	_right_arrow.label_place = Arrow.LabelPlace.MIDDLE
	_right_arrow.lay(_moved.position, _right.position)
	_right_arrow.keep_label_from(_easy.position)
	_easy_arrow.visible = not _are_same
	_easy_arrow.label = tr("easy")
	_easy_arrow.label_place = Arrow.LabelPlace.MIDDLE
	_easy_arrow.lay(_moved.position, _easy.position)
	_easy_arrow.keep_label_from(_right.position)


func _show_flip() -> void:
	var from := _right.position
	_right_ball.visible = _model.right_detects(_moved)
	_right_ball.lay(from, _moved.radius)
	if not _model.right_reflects(_moved) and not _model.easy_flips(_moved):
		return
	_right_arrow.visible = true
	_right_arrow.label = tr("flipped") if _are_same else tr("right")
	_right_arrow.label_place = Arrow.LabelPlace.HEAD
	_right_arrow.lay(from, from.plus(_right.velocity))
	_easy_arrow.visible = not _are_same
	_easy_arrow.label = tr("easy")
	_easy_arrow.label_place = Arrow.LabelPlace.HEAD
	_easy_arrow.lay(from, from.plus(_easy.velocity))
	var foot := _model.shortest_foot(from)
	_normal.visible = not _are_same
	_normal.lay(foot, foot.plus(_model.normal().scaled(2.0 * _moved.radius)))
	_normal.keep_label_from(from.plus(_easy.velocity))


func _show_bounce() -> void:
	var now := _model.frame()
	_right_path.visible = true
	_right_path.label = "" if _are_same else tr("right")
	_right_path.lay(_places(_model.right_result), _moved.radius)
	_easy_path.visible = not _are_same
	_easy_path.lay(_places(_model.easy_result), _moved.radius)
	var easy := _model.ball_after(now, _model.easy_result)
	var right := _model.ball_after(now, _model.right_result)
	_show_balls(easy.position, right.position)


func _show_balls(easy: Vec2, right: Vec2) -> void:
	_right_ball.visible = true
	_right_ball.lay(right, _moved.radius)
	_easy_ball.visible = not _are_same
	_easy_ball.lay(easy, _moved.radius)


func _places(program: Callable) -> Array[Vec2]:
	var places: Array[Vec2] = []
	for in_frame in range(_model.first_frame(), EasyBounceModel.FRAMES_AFTER + 1):
		places.append(_model.ball_after(in_frame, program).position)
	return places
