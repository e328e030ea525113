class_name AngledLinesDrawing
extends Node2D
## The drawing of the lesson on angled lines: lines, balls, trails, what comes next, gravity.

## Asks for another place and velocity of the selected ball. Comes many times during a drag.
signal ball_changed(position: Vec2, velocity: Vec2)
## A drag or nudge of the ball or of its velocity has ended.
signal ball_released

# Seconds of motion that the velocity arrow is long, for slow balls and for fast ones.
const _ARROW_SECONDS := 0.25
const _FAST_ARROW_SECONDS := 0.02
# From this speed on a ball is fast, in px/s.
const _FAST := 1000.0
# Pixels of the plane that a unit normal is drawn long, to be seen.
const _NORMAL_LENGTH := 40.0
# Half of what the board shows at least, in pixels of the plane.
const _HALF_VIEW := Vector2i(290, 200)
# The same with the timeline, which covers the foot of the board.
const _HALF_VIEW_WITH_TIMELINE := Vector2i(290, 245)

## Whether trails are drawn.
var has_trails := true:
	set(value):
		has_trails = value
		_trails.visible = value
		_wrong_trails.visible = value

var _arrow_seconds := _ARROW_SECONDS
# The selected ball, whose velocity the arrow shows.
var _ball: Ball

@onready var _lines: LineViews = %Lines
@onready var _endless_lines: EndlessLineViews = %EndlessLines
@onready var _trails: BallTrails = %Trails
@onready var _wrong_trails: BallTrails = %WrongTrails
@onready var _balls: BallsView = %Balls
@onready var _wrong_balls: BallsView = %WrongBalls
@onready var _path: PathView = %Path
@onready var _wrong_path: PathView = %WrongPath
@onready var _impact: BallView = %Impact
@onready var _normal: Arrow = %Normal
@onready var _velocity: DraggableVector = %Velocity
@onready var _gravity: GravityArrow = %Gravity


func _ready() -> void:
	_velocity.moved.connect(_ask_for_ball)
	_velocity.released.connect(ball_released.emit)


## The world with the lines, balls and gravity that the scene has at the start, and this bounciness.
## What the world refuses is pushed as an error.
func world_at_start(bounciness: float) -> SteppedWorld:
	var world := SteppedWorld.new(WholeFrameMover.new())
	Refusal.push(world.surroundings.set_segments(_lines.lines_at_start()))
	Refusal.push(world.surroundings.set_gravity(_gravity.pull()))
	Refusal.push(world.surroundings.set_bounciness(bounciness))
	Refusal.push(world.set_balls(_balls.balls_at_start()))
	return world


## Draws the steps of [param player] into the trails, and counts the time of drawing in its meter.
func follow(player: AngledLinesPlayer, model: AngledLinesModel) -> void:
	player.stepped.connect(func(is_forward: bool) -> void: _follow_step(model, is_forward))
	_balls.meter = player.meter
	_wrong_balls.meter = player.meter
	for part: CanvasItem in [_lines, _gravity]:
		(%Grid as Grid).take(part)


## A point that must be on the board; the origin is in its middle.
func outline(model: AngledLinesModel) -> Array[Vec2]:
	var half := _HALF_VIEW_WITH_TIMELINE if model.timeline else _HALF_VIEW
	return [Vec2.new(half.x, half.y)]


## Chooses how many seconds of motion the arrow of the velocity is long. Not during a drag of that
## arrow: it would jump.
func scale_arrow(model: AngledLinesModel) -> void:
	var speed := model.ball().velocity.length()
	_arrow_seconds = _FAST_ARROW_SECONDS if speed > _FAST else _ARROW_SECONDS


## Shows the lines of [param model] and its gravity. Trails that do not lead to the balls begin
## anew.
func show_model(model: AngledLinesModel) -> void:
	var no_lines: Array[LineSegment] = []
	_lines.show_lines(model.lines())
	_endless_lines.show_lines(model.lines() if model.has_endless_lines else no_lines)
	_gravity.show_gravity(model.world.surroundings.gravity)
	if not (_trails.lead_to(model.world) and _wrong_trails.lead_to(_wrong_world(model))):
		begin_trails(model)


## Trails begin anew where the balls are.
func begin_trails(model: AngledLinesModel) -> void:
	_trails.begin(model.world)
	_wrong_trails.begin(_wrong_world(model))


## Shows where the balls of [param model] are now, and what comes next; null where time runs.
func show_moment(model: AngledLinesModel, forecast: BallForecast) -> void:
	_ball = model.ball()
	_balls.show_world(model.world)
	_wrong_balls.show_world(model.wrong_world)
	_velocity.visible = model.world.is_lost[model.selected] == 0
	_velocity.lay(_ball.position, _ball.position.plus(_ball.velocity.scaled(_arrow_seconds)))
	_path.show_path([])
	_wrong_path.show_path([])
	_show_bounce(forecast.next_bounce if forecast else null)
	if forecast:
		_path.show_path(forecast.path)
		if model.wrong_world:
			_wrong_path.show_path(model.forecast(model.wrong_world).path)


func _show_bounce(bounce: BounceRecord) -> void:
	_impact.visible = bounce != null
	_normal.visible = bounce != null
	_path.clear_note()
	if bounce:
		var foot := bounce.position.minus(bounce.normal.scaled(_ball.radius))
		_impact.lay(bounce.position, _ball.radius)
		_normal.lay(foot, foot.plus(bounce.normal.scaled(_NORMAL_LENGTH)))
		_path.show_note(AngledLinesTexts.impact_label(bounce), bounce.position, bounce.normal)


# Without balls where no mistake is switched on.
func _wrong_world(model: AngledLinesModel) -> SteppedWorld:
	return model.wrong_world if model.wrong_world else SteppedWorld.new(WholeFrameMover.new())


# A step on makes the trails longer, a step back takes the latest stroke away.
func _follow_step(model: AngledLinesModel, is_forward: bool) -> void:
	var trails: Dictionary[BallTrails, SteppedWorld] = {_trails: model.world}
	if model.wrong_world:
		trails[_wrong_trails] = model.wrong_world
	for trail in trails:
		if is_forward:
			trail.add_frame(trails[trail])
		else:
			trail.remove_frame(trails[trail])


# Only a drag of the head leaves the tail, and with it the ball, where it is.
func _ask_for_ball(tail: Vec2, head: Vec2) -> void:
	if tail.distance_to(_ball.position) > 0.0:
		ball_changed.emit(tail, _ball.velocity)
	else:
		ball_changed.emit(_ball.position, head.minus(tail).divided(_arrow_seconds))
