class_name AngledLinesDrawing
extends Node2D
## The drawing of the lesson on angled lines: lines, balls, trails, what comes next, gravity.

# Seconds of motion that the velocity arrow is long, for slow balls and for fast ones.
const _ARROW_SECONDS := 0.25
const _FAST_ARROW_SECONDS := 0.02
const _FAST := 1000.0
# Pixels of the plane that a unit normal is drawn long, to be seen.
const _NORMAL_LENGTH := 40.0

## Trails are drawn.
var has_trails := true:
	set(value):
		has_trails = value
		_trails.visible = value
		_wrong_trails.visible = value

var _arrow_seconds := _ARROW_SECONDS

@onready var _lines: LineViews = %Lines
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


## Counts the time of drawing in [param meter], too.
func measure_with(meter: FrameMeter) -> void:
	_balls.meter = meter
	_wrong_balls.meter = meter


## Shows all of [param model] anew; trails begin where the balls are.
func show_all(model: AngledLinesModel) -> void:
	var speed := model.ball().velocity.length()
	_arrow_seconds = _FAST_ARROW_SECONDS if speed > _FAST else _ARROW_SECONDS
	clear_trails(model)


## Trails begin anew where the balls are.
func clear_trails(model: AngledLinesModel) -> void:
	_trails.begin(model.world)
	_wrong_trails.begin(
		model.wrong_world if model.wrong_world else SteppedWorld.new(WholeFrameMover.new())
	)


## Shows the lines of [param model] and its gravity.
func show_surroundings(model: AngledLinesModel) -> void:
	_lines.show_lines(model.lines())
	_gravity.show_gravity(model.world.surroundings.gravity)


## Shows where the balls of [param model] are now.
func show_balls(model: AngledLinesModel) -> void:
	var ball := model.ball()
	_balls.show_world(model.world)
	_wrong_balls.show_world(model.wrong_world)
	_velocity.visible = model.world.is_lost[model.selected] == 0
	_velocity.lay(ball.position, ball.position.plus(ball.velocity.scaled(_arrow_seconds)))


## Adds the latest step of [param model] to the trails, or takes the latest away.
func follow_step(model: AngledLinesModel, is_forward: bool) -> void:
	if is_forward:
		_trails.add_frame(model.world)
		if model.wrong_world:
			_wrong_trails.add_frame(model.wrong_world)
	else:
		_trails.remove_frame(model.world)
		if model.wrong_world:
			_wrong_trails.remove_frame(model.wrong_world)


## Shows what comes next for the selected ball, and what would come with the mistake.
func show_forecast(model: AngledLinesModel, forecast: BallForecast) -> void:
	var bounce := forecast.next_bounce
	_path.show_path(forecast.path)
	_path.show_note(AngledLinesTexts.impact_label(bounce) if bounce else "", bounce)
	_wrong_path.show_path([])
	if model.wrong_world:
		_wrong_path.show_path(model.forecast(model.wrong_world).path)
	_impact.visible = bounce != null
	_normal.visible = bounce != null
	if bounce:
		var radius := model.ball().radius
		var foot := bounce.position.minus(bounce.normal.scaled(radius))
		_impact.lay(bounce.position, radius)
		_normal.lay(foot, foot.plus(bounce.normal.scaled(_NORMAL_LENGTH)))


## Shows nothing of what comes next.
func hide_forecast() -> void:
	_path.show_path([])
	_path.show_note("", null)
	_wrong_path.show_path([])
	_impact.visible = false
	_normal.visible = false


## The velocity that belongs to an arrow from [param tail] to [param head].
func velocity_of(tail: Vec2, head: Vec2) -> Vec2:
	return head.minus(tail).divided(_arrow_seconds)
