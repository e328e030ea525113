class_name NewtonBallsDrawing
extends Node2D
## The drawing of the lesson on balls that meet: the balls as they fly, what happens where two of
## them meet, and the verdict.

## So many balls have an arrow that can be dragged; of more balls only the two that meet have one.
const MOST_ARROWS := 6
# Pixels above a ball's rim where the handle for its mass is.
const _STEM := 30.0
# A handle on the grid leads to stems of this length, in units.
const _STEM_STEP := 0.5
# How long both pushes are drawn: equal, whatever J is.
const _PUSH := 2.5
# Between the balls and the picture of their meeting below them, in units.
const _BELOW := 0.8
# The line for C is ten steps of the grid long, and lies so far above the lower edge.
const _HALF_SCALE := 5.0
const _ABOVE_EDGE := 30.0

var _vectors: Array[DraggableVector] = []
# Which ball each of the arrows belongs to; -1 for none.
var _indices: PackedInt32Array = []

@onready var _box: BallBox = %Box
@onready var _crowd: BallCrowd = %Crowd
@onready var _ghosts: Array[BallView] = [%Ghost1, %Ghost2]
@onready var _normal: Arrow = %Normal
@onready var _coming: Array[Arrow] = [%Coming1, %Coming2]
@onready var _parts: Array[Arrow] = [%Part1, %Part2]
@onready var _center: TargetMark = %Center
@onready var _center_velocity: Arrow = %CenterVelocity
@onready var _center_stem: Arrow = %CenterStem
@onready var _seen: Array[Arrow] = [%Seen1, %Seen2]
@onready var _leaving: Array[Arrow] = [%Leaving1, %Leaving2]
@onready var _pushes: Array[Arrow] = [%Push1, %Push2]
@onready var _after: Array[Arrow] = [%After1, %After2]
@onready var _wrong: Array[Arrow] = [%Wrong1, %Wrong2]
@onready var _stems: Array[Arrow] = [%Stem1, %Stem2]
@onready var _mass_handles: Array[Handle] = [%Mass1, %Mass2]
@onready var _scale: Arrow = %Scale
@onready var _bounciness: Handle = %Bounciness
@onready var _card: Control = %MomentaCard
@onready var _momenta: MomentaBoard = %Momenta
@onready var _ledger: Label = %Ledger
@onready var _verdict: VerdictCard = %Verdict


## Where the velocity of ball 1 before the meeting ends, in the picture of the meeting.
func head_before(model: NewtonBallsModel, meeting: BallMeeting) -> Vec2:
	return _head_of(model, meeting, meeting.one.velocity)


## The same after the meeting.
func head_after(model: NewtonBallsModel, meeting: BallMeeting) -> Vec2:
	return _head_of(model, meeting, meeting.velocities_after()[0])


func _head_of(model: NewtonBallsModel, meeting: BallMeeting, velocity: Vec2) -> Vec2:
	return meeting.one.position.plus(drop(model, meeting)).plus(velocity)


func _ready() -> void:
	for number: int in MOST_ARROWS:
		_vectors.append(get_node("%%Ball%d" % (number + 1)) as DraggableVector)
		_indices.append(-1)


## The arrows that can be dragged, in order.
func vectors() -> Array[DraggableVector]:
	return _vectors


## The ball to which the arrow number [param place] belongs, counted from 0.
func ball_of(place: int) -> int:
	return _indices[place]


## Chooses which balls have an arrow: not during a drag, when others may come to meet.
func choose_arrows(model: NewtonBallsModel, meeting: BallMeeting) -> void:
	_indices.clear()
	var count := model.balls.size()
	for place: int in MOST_ARROWS:
		if count <= MOST_ARROWS:
			_indices.append(place if place < count else -1)
		elif place < 2:
			var pair := Vector2i(meeting.first, meeting.second) if meeting else Vector2i(0, 1)
			_indices.append(pair[place])
		else:
			_indices.append(-1)


## Draws [param model] and its [param run] as far as [param step] has got.
func show_model(model: NewtonBallsModel, run: BallRun, seconds: float, step: int) -> void:
	var meeting := run.meeting
	_box.visible = model.has_box
	_lay_scale(model)
	_lay_meeting(model, meeting, step)
	_lay_changes(model, meeting, step)
	_lay_momenta(meeting, step)
	_show_verdict(model, meeting, step)
	show_moment(model, run, seconds, step)


## Shows what flies, where it is after [param seconds].
func show_moment(model: NewtonBallsModel, run: BallRun, seconds: float, step: int) -> void:
	var balls := run.balls()
	var meeting := run.meeting
	var moved := _moved(model, meeting, seconds, step)
	var pair := Vector2i(meeting.first, meeting.second) if meeting else Vector2i(0, 1)
	_crowd.show_balls(balls, moved, pair.x, pair.y)
	_lay_vectors(model, balls, pair, _is_seen_from_center(model, meeting, step))
	_lay_masses(model, balls, step)
	_lay_center(model, meeting, balls, moved, step)
	if _card.visible:
		_ledger.text = NewtonBallsTexts.ledger(run, seconds)


## The mass for which a handle at [param knob] stands above the ball at [param center].
func mass_for(center: Vec2, knob: Vec2) -> float:
	var radius := absf(center.y - knob.y) - _stem()
	var mass := radius * absf(radius)
	return maxf(roundf(mass), 1.0) if mass >= 0.75 else maxf(snappedf(mass, 0.25), 0.25)


## The bounciness for a handle at [param knob] on its line.
func bounciness_for(knob: Vec2) -> float:
	var length := 2.0 * _HALF_SCALE * _crowd.board.grid_step
	return clampf(roundf(20.0 * (knob.x / length + 0.5)) / 20.0, 0.0, 1.0)


## What the board has to show: all that can be dragged, and what the bounce leads to.
func points_to_show(model: NewtonBallsModel, meeting: BallMeeting) -> Array[Vec2]:
	var points: Array[Vec2] = []
	if model.has_box:
		points.append(Vec2.new(BallRun.HALF_BOX[0], BallRun.HALF_BOX[1]))
	for ball in model.world_balls():
		var rim := Vec2.new(ball.radius, ball.radius)
		points.append_array([ball.position.plus(rim), ball.position.minus(rim)])
		if model.is_pair():
			points.append(ball.position.minus(rim).minus(Vec2.new(0.0, 1.0)))
		if model.balls.size() <= MOST_ARROWS:
			points.append(ball.position.plus(ball.velocity))
	if meeting and not model.has_box:
		var after := meeting.velocities_after()
		var below := drop(model, meeting)
		for ball: Ball in [meeting.one, meeting.two]:
			points.append(ball.position.plus(below).plus(Vec2.new(ball.radius, ball.radius)))
		points.append(meeting.one.position.plus(below).plus(after[0]))
		points.append(meeting.two.position.plus(below).plus(after[1]))
	var lowest := 0.0
	for point in points:
		lowest = maxf(lowest, point.y)
	# Room for the line with C.
	points.append(Vec2.new(0.0, lowest + 1.5))
	return points


static func _is_seen_from_center(model: NewtonBallsModel, meeting: BallMeeting, step: int) -> bool:
	return step == NewtonBallsModel.Step.FRAME and model.is_pair() and meeting != null


# How far all is moved for somebody who moves with the centre of mass.
static func _moved(
	model: NewtonBallsModel, meeting: BallMeeting, seconds: float, step: int
) -> Vec2:
	if not _is_seen_from_center(model, meeting, step):
		return Vec2.new()
	return meeting.center_velocity().scaled(-seconds)


## How far below the balls the picture of their meeting is drawn: without a box, so that no arrows
## lie on each other.
func drop(model: NewtonBallsModel, meeting: BallMeeting) -> Vec2:
	if model.has_box:
		return Vec2.new()
	var lowest := -INF
	for ball in model.world_balls():
		lowest = maxf(
			lowest, maxf(ball.position.y + ball.radius, ball.position.y + ball.velocity.y)
		)
	var after := meeting.velocities_after()
	var highest := minf(
		meeting.one.position.y + minf(-meeting.one.radius, after[0].y),
		meeting.two.position.y + minf(-meeting.two.radius, after[1].y)
	)
	return Vec2.new(0.0, maxf(lowest - highest, 0.0) + _BELOW)


func _lay_scale(model: NewtonBallsModel) -> void:
	var board := _crowd.board
	var below := Vector2(board.size.x / 2.0, board.free_area().end.y - _ABOVE_EDGE)
	var y := board.to_plane(below).y
	var half := _HALF_SCALE * board.grid_step
	_scale.lay(Vec2.new(-half, y), Vec2.new(half, y))
	_scale.label = "C = %s" % NumberText.short(model.bounciness)
	_bounciness.place(Vec2.new(half * (2.0 * model.bounciness - 1.0), y))


# The two balls where they meet, and what happens along n.
func _lay_meeting(model: NewtonBallsModel, meeting: BallMeeting, step: int) -> void:
	var is_step := step >= NewtonBallsModel.Step.NORMAL and step != NewtonBallsModel.Step.CENTER
	var is_shown := meeting != null and is_step
	_normal.visible = is_shown and step < NewtonBallsModel.Step.MOMENTUM
	for place: int in 2:
		_ghosts[place].visible = is_shown
		_coming[place].visible = is_shown and step == NewtonBallsModel.Step.NORMAL
		_parts[place].visible = _coming[place].visible
		_pushes[place].visible = is_shown and step == NewtonBallsModel.Step.IMPULSE
	if not is_shown:
		return
	var moved := _moved(model, meeting, meeting.time, step).plus(drop(model, meeting))
	var balls: Array[Ball] = [meeting.one, meeting.two]
	for place: int in 2:
		var center := balls[place].position.plus(moved)
		_ghosts[place].lay(center, balls[place].radius)
		var velocity := balls[place].velocity
		_lay_arrow(_coming[place], center, velocity)
		_lay_arrow(_parts[place], center, velocity.vector_projection(meeting.normal))
		_lay_arrow(_pushes[place], center, meeting.normal.scaled(_PUSH if place == 1 else -_PUSH))
	var touch := meeting.one.position.plus(meeting.normal.scaled(meeting.one.radius)).plus(moved)
	_lay_arrow(_normal, touch, meeting.normal)


# An arrow of no length is not shown.
static func _lay_arrow(arrow: Arrow, tail: Vec2, along: Vec2) -> void:
	arrow.lay(tail, tail.plus(along))
	arrow.visible = arrow.visible and along.length() > 0.0


# The velocities after the bounce, right and wrong, and as the centre of mass sees them.
func _lay_changes(model: NewtonBallsModel, meeting: BallMeeting, step: int) -> void:
	var is_after := meeting != null and step >= NewtonBallsModel.Step.AFTER
	var is_seen := _is_seen_from_center(model, meeting, step)
	var is_compared := NewtonBallsTexts.is_compared(model, meeting, step)
	var shows_wrong := is_compared and model.mistake_shows(meeting)
	for place: int in 2:
		_after[place].visible = is_after
		_leaving[place].visible = is_seen
		_wrong[place].visible = shows_wrong
	if not is_after and not is_seen:
		return
	var right := meeting.velocities_after()
	var wrong := NewtonBallsMistakes.velocities_after(model.shown_mistake(), meeting)
	for place: int in 2:
		var center := _ghosts[place].at()
		_lay_arrow(_after[place], center, right[place])
		_lay_arrow(_leaving[place], center, right[place].minus(meeting.center_velocity()))
		_lay_arrow(_wrong[place], center, wrong[place])


func _lay_vectors(
	model: NewtonBallsModel, balls: Array[Ball], pair: Vector2i, from_center: bool
) -> void:
	for place: int in MOST_ARROWS:
		var index := _indices[place]
		var is_there := index >= 0 and index < balls.size()
		_vectors[place].visible = is_there and not from_center
		if not is_there:
			continue
		var ball := balls[index]
		_vectors[place].lay(ball.position, ball.position.plus(ball.velocity))
		_vectors[place].label = _velocity_name(index, pair)
		_vectors[place].role = _role_of(index, pair)
		_vectors[place].show_label(model.balls.size() <= 2 and ball.velocity.length() > 0.0)


static func _velocity_name(index: int, pair: Vector2i) -> String:
	if index == pair.x:
		return "v₁"
	return "v₂" if index == pair.y else "v"


static func _role_of(index: int, pair: Vector2i) -> Palette.Role:
	if index == pair.x:
		return Palette.Role.A
	return Palette.Role.B if index == pair.y else Palette.Role.QUIET


func _lay_masses(model: NewtonBallsModel, balls: Array[Ball], step: int) -> void:
	var is_shown := model.is_pair() and step != NewtonBallsModel.Step.FRAME
	for place: int in 2:
		_stems[place].visible = is_shown
		_mass_handles[place].visible = is_shown
		if is_shown:
			var center := balls[place].position
			var rim := center.plus(Vec2.new(0.0, -balls[place].radius))
			var knob := rim.plus(Vec2.new(0.0, -_stem()))
			_stems[place].lay(rim, knob)
			_mass_handles[place].place(knob)


func _stem() -> float:
	var length := _STEM / _crowd.board.pixels_per_unit
	return maxf(snappedf(length, _STEM_STEP), _STEM_STEP)


# The centre of mass of ball 1 and ball 2, moving with them while nothing else pushes them.
func _lay_center(
	model: NewtonBallsModel, meeting: BallMeeting, balls: Array[Ball], moved: Vec2, step: int
) -> void:
	var is_step := step in [NewtonBallsModel.Step.CENTER, NewtonBallsModel.Step.FRAME]
	var is_shown := meeting != null and is_step
	var is_seen := _is_seen_from_center(model, meeting, step)
	_center.visible = is_shown
	_center_velocity.visible = is_shown and not is_seen
	_center_stem.visible = is_shown and not is_seen
	for place: int in 2:
		_seen[place].visible = is_seen
	if not is_shown:
		return
	var place_of_center := meeting.center()
	if model.is_pair():
		place_of_center = BallMeeting.new(balls[0], balls[1], 1.0).center().plus(moved)
	var velocity := meeting.center_velocity()
	_center.lay(place_of_center, 0.0)
	var radius := maxf(meeting.one.radius, meeting.two.radius)
	var below := place_of_center.plus(Vec2.new(0.0, radius + _BELOW))
	_center_stem.lay(place_of_center, below)
	_lay_arrow(_center_velocity, below, velocity)
	for place: int in 2 if is_seen else 0:
		var at := balls[place].position.plus(moved)
		_seen[place].lay(at, at.plus(balls[place].velocity.minus(velocity)))


func _lay_momenta(meeting: BallMeeting, step: int) -> void:
	_card.visible = meeting != null and step >= NewtonBallsModel.Step.MOMENTUM
	if not _card.visible:
		return
	_momenta.is_y_up = _crowd.board.is_y_up
	var after := meeting.velocities_after()
	_momenta.show_momenta(
		[
			meeting.one.velocity.scaled(meeting.one.mass),
			meeting.two.velocity.scaled(meeting.two.mass)
		],
		[after[0].scaled(meeting.one.mass), after[1].scaled(meeting.two.mass)]
	)


func _show_verdict(model: NewtonBallsModel, meeting: BallMeeting, step: int) -> void:
	_verdict.visible = step >= NewtonBallsModel.Step.CENTER or not meeting
	var sign_text := "=" if meeting else "×"
	var role := Palette.Role.PROJECTION if meeting else Palette.Role.QUIET
	if NewtonBallsTexts.is_compared(model, meeting, step) and model.mistake_shows(meeting):
		sign_text = "✗"
		role = Palette.Role.WRONG
	_verdict.show_verdict(sign_text, role, NewtonBallsTexts.verdict(model, meeting, step))
