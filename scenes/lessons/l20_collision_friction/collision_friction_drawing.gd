class_name CollisionFrictionDrawing
extends Node2D
## The drawing of the lesson on friction at a bounce: the ball that comes and leaves, what acts
## where it touches, and the verdict.

## Arrows of velocities and impulses show what they do in so many seconds.
const ARROW_SECONDS := 0.2
# Velocities and rim speeds that are dragged are multiples of this, in px/s.
const _SPEED_STEP := 10.0
# Friction that is dragged is a multiple of this.
const _FRICTION_STEP := 0.025
# The cone is so much longer than the impulse, and never shorter than so many radii.
const _CONE_REACH := 1.05
const _SHORTEST_CONE := 4.0
# A path is drawn through so many places.
const _PIECES := 60
# Below the contact there is room for so many radii: names and cards stand there.
const _ROOM_BELOW := 1.5
# The ledger takes so much of the height of all else.
const _ROOM_FOR_LEDGER := 0.4

@onready var _surface: Arrow = %Surface
@onready var _line_handle: Handle = %LineHandle
@onready var _path: FlightPath = %Path
@onready var _path_of_other: FlightPath = %PathOfOther
@onready var _cone: FrictionCone = %Cone
@onready var _cone_handle: Handle = %ConeHandle
@onready var _ghost: BallView = %Ghost
@onready var _other: TurnedBall = %Other
@onready var _ball: TurnedBall = %Ball
@onready var _velocity: Arrow = %Velocity
@onready var _velocity_handle: Handle = %VelocityHandle
@onready var _rim: Arrow = %Rim
@onready var _spin_handle: Handle = %SpinHandle
@onready var _slip: Arrow = %Slip
@onready var _push: Arrow = %Push
@onready var _impulse: Arrow = %Impulse
@onready var _after: Array[Arrow] = [%After, %AfterOfOther]
@onready var _wrong: Array[Arrow] = [%Wrong, %WrongOfOther]
@onready var _ledger: ContactLedger = %Ledger
@onready var _verdict: VerdictCard = %Verdict


## Draws [param model] as far as [param step] has got.
func show_model(
	model: CollisionFrictionModel, contact: FrictionContact, flight: ContactFlight, step: int
) -> void:
	_lay_surface(model, contact, flight, step)
	_lay_coming(contact)
	_lay_acting(contact, step)
	_lay_leaving(model, contact, step)
	_lay_paths(flight, contact, step)
	_ledger.visible = step >= CollisionFrictionModel.Step.LEDGER
	_ledger.show_contact(contact)
	_show_verdict(model, contact, flight, step)


## Shows the balls where they are after [param seconds].
func show_moment(contact: FrictionContact, flight: ContactFlight, seconds: float) -> void:
	flight.go_to(seconds)
	var views: Array[TurnedBall] = [_ball, _other]
	_other.visible = contact.other != null
	for index: int in contact.before().size():
		views[index].lay(flight.ball(index).position, contact.ball.radius)
		views[index].turn = flight.angle(index)
	var sentence := LabText.translate("%s s")
	_ball.label = sentence % NumberText.short(seconds, 3) if seconds > 0.0 else ""


## The velocity for a handle at [param tail], in px/s.
static func velocity_for(contact: FrictionContact, tail: Vec2) -> Vec2:
	var wanted := contact.ball.position.minus(tail).divided(ARROW_SECONDS)
	return Vec2.new(snappedf(wanted.x, _SPEED_STEP), snappedf(wanted.y, _SPEED_STEP))


## The spin for a handle at [param knob], in rad/s.
static func spin_for(contact: FrictionContact, knob: Vec2) -> float:
	var rim := snappedf(knob.dot(contact.tangent) / ARROW_SECONDS, _SPEED_STEP)
	return rim / contact.ball.radius


## The friction for the edge of the cone at [param knob].
static func friction_for(contact: FrictionContact, knob: Vec2) -> float:
	var high := knob.dot(contact.normal)
	if high <= 0.0:
		return CollisionFrictionModel.MOST_FRICTION
	var wanted := snappedf(maxf(knob.dot(contact.tangent), 0.0) / high, _FRICTION_STEP)
	return minf(wanted, CollisionFrictionModel.MOST_FRICTION)


## Where the arrow of the velocity ends that is asked for: of the ball, or of the other one.
static func head_after(contact: FrictionContact) -> Vec2:
	return _head_of(contact.after()[-1])


## Where it would end without friction.
static func head_without_friction(contact: FrictionContact) -> Vec2:
	return _head_of(contact.after_with(0.0, 0.0)[-1])


static func _head_of(ball: Ball) -> Vec2:
	return ball.position.plus(ball.velocity.scaled(ARROW_SECONDS))


## What the board has to show at [param step]: all that can be dragged, and the ways of the balls.
func points_to_show(
	contact: FrictionContact, flight: ContactFlight, along: Vec2, step: int
) -> Array[Vec2]:
	var reach := _reach(contact)
	var below := contact.normal.scaled(-_ROOM_BELOW * contact.ball.radius)
	var points: Array[Vec2] = [
		along,
		along.negated(),
		below,
		contact.normal.scaled(reach),
		_edge(contact, reach),
		_tail(contact),
		_rim_head(contact),
		contact.tangent.scaled(contact.slip() * ARROW_SECONDS),
		head_after(contact),
		head_without_friction(contact),
		flight.start.position,
	]
	var is_flight := step == CollisionFrictionModel.Step.FLY
	var last := ContactPlayer.end_of(flight, step if is_flight else 0)
	for index: int in contact.before().size():
		points.append_array(flight.way(index, last, _PIECES))
	if step >= CollisionFrictionModel.Step.LEDGER and not _ball.board.is_small():
		points.append(_below_all(points))
	return points


# So far down that the ledger has room below everything else.
static func _below_all(points: Array[Vec2]) -> Vec2:
	var low := points[0].y
	var high := points[0].y
	for point in points:
		low = minf(low, point.y)
		high = maxf(high, point.y)
	return Vec2.new(0.0, high + _ROOM_FOR_LEDGER * (high - low))


# Where the velocity begins that ends in the ball at the contact.
static func _tail(contact: FrictionContact) -> Vec2:
	return contact.ball.position.minus(contact.ball.velocity.scaled(ARROW_SECONDS))


# The point of the rim that is farthest from the surface, ...
static func _top(contact: FrictionContact) -> Vec2:
	return contact.normal.scaled(2.0 * contact.ball.radius)


# ... and where it would be after the time of an arrow, seen from the ball.
static func _rim_head(contact: FrictionContact) -> Vec2:
	var rim := contact.ball.spin * contact.ball.radius * ARROW_SECONDS
	return _top(contact).plus(contact.tangent.scaled(rim))


static func _reach(contact: FrictionContact) -> float:
	var lean := sqrt(1.0 + minf(contact.friction, 1.0) ** 2)
	var reach := _CONE_REACH * lean * contact.push() * ARROW_SECONDS
	return maxf(reach, _SHORTEST_CONE * contact.ball.radius)


static func _edge(contact: FrictionContact, reach: float) -> Vec2:
	var leaning := contact.normal.plus(contact.tangent.scaled(contact.friction))
	return leaning.normalized().scaled(reach)


# The line is as long as the flight needs.
func _lay_surface(
	model: CollisionFrictionModel, contact: FrictionContact, flight: ContactFlight, step: int
) -> void:
	var half := model.along.length()
	if step == CollisionFrictionModel.Step.FLY and not contact.other:
		for place in flight.way(0, flight.end, _PIECES):
			half = maxf(half, absf(place.dot(contact.tangent)))
	var end_point := contact.tangent.scaled(half)
	_surface.lay(end_point.negated(), end_point)
	_surface.dashed = model.two_balls
	_surface.role = Palette.Role.QUIET if model.two_balls else Palette.Role.INK
	_line_handle.place(model.along)


func _lay_coming(contact: FrictionContact) -> void:
	_ghost.lay(contact.ball.position, contact.ball.radius)
	_velocity.label = "v₁" if contact.other else "v"
	_velocity.keep_label_from(_top(contact))
	_velocity.lay(_tail(contact), contact.ball.position)
	_velocity_handle.place(_tail(contact))
	_rim.lay(_top(contact), _rim_head(contact))
	_rim.visible = contact.ball.spin != 0.0
	_spin_handle.place(_rim_head(contact))


func _lay_acting(contact: FrictionContact, step: int) -> void:
	var is_flight := step == CollisionFrictionModel.Step.FLY
	var origin := Vec2.zero()
	var has_slip := step >= CollisionFrictionModel.Step.SLIP and not is_flight
	_lay_arrow(_slip, origin, contact.tangent.scaled(contact.slip()), has_slip)
	var has_push := step >= CollisionFrictionModel.Step.PUSH and not is_flight
	_lay_arrow(_push, origin, contact.normal.scaled(contact.push()), has_push)
	var has_cone := step >= CollisionFrictionModel.Step.CONE
	var impulse := CollisionFrictionFormula.impulse_of(contact)
	_lay_arrow(_impulse, origin, impulse, has_cone)
	_slip.keep_label_from(contact.normal)
	# Beside it the other ball would be.
	_slip.label_place = Arrow.LabelPlace.HEAD if contact.other else Arrow.LabelPlace.MIDDLE
	_impulse.keep_label_from(contact.normal.scaled(contact.push()))
	_cone.visible = has_cone
	_cone_handle.visible = has_cone
	_cone.show_cone(contact.normal, contact.friction, _reach(contact))
	_cone_handle.place(_edge(contact, _reach(contact)))


func _lay_leaving(model: CollisionFrictionModel, contact: FrictionContact, step: int) -> void:
	var is_after := step >= CollisionFrictionModel.Step.AFTER
	var shows_wrong := CollisionFrictionTexts.is_compared(model, step) and model.shows_mistake()
	var right := contact.after()
	var wrong := CollisionFrictionMistakes.balls_after(model.mistake, contact)
	_after[0].label = "v₁′" if contact.other else "v′"
	for place: int in 2:
		var is_there := place < right.size()
		_after[place].visible = false
		_wrong[place].visible = false
		if is_there:
			var center := right[place].position
			_after[place].keep_label_from(contact.normal.scaled(contact.push()))
			_lay_arrow(_after[place], center, right[place].velocity, is_after)
			_lay_arrow(_wrong[place], center, wrong[place].velocity, shows_wrong)


# An arrow of no length is not shown.
static func _lay_arrow(arrow: Arrow, from: Vec2, speed: Vec2, is_shown: bool) -> void:
	arrow.lay(from, from.plus(speed.scaled(ARROW_SECONDS)))
	arrow.visible = is_shown and speed.length() > 0.0


func _lay_paths(flight: ContactFlight, contact: FrictionContact, step: int) -> void:
	var is_flight := step == CollisionFrictionModel.Step.FLY
	_path.visible = is_flight
	_path_of_other.visible = is_flight and contact.other != null
	if is_flight:
		_path.show_path(flight.way(0, flight.end, _PIECES))
		if contact.other:
			_path_of_other.show_path(flight.way(1, flight.end, _PIECES))


func _show_verdict(
	model: CollisionFrictionModel, contact: FrictionContact, flight: ContactFlight, step: int
) -> void:
	_verdict.visible = step >= CollisionFrictionModel.Step.CONE
	if not _verdict.visible:
		return
	var sign_text := "="
	var role := Palette.Role.PROJECTION
	if contact.regime() == Friction.Regime.SLIP:
		sign_text = "≠"
		role = Palette.Role.REST
	if CollisionFrictionTexts.is_compared(model, step) and model.shows_mistake():
		sign_text = "✗"
		role = Palette.Role.WRONG
	var words := CollisionFrictionTexts.verdict(model, contact, flight, step)
	_verdict.show_verdict(sign_text, role, words)
	_verdict.keep_off(_taken_places(contact, flight), 24.0)


func _taken_places(contact: FrictionContact, flight: ContactFlight) -> PackedVector2Array:
	var board := _ball.board
	var places: PackedVector2Array = []
	var rim := Vec2.new(0.0, contact.ball.radius)
	var points: Array[Vec2] = [
		_tail(contact),
		head_after(contact),
		_rim_head(contact),
		_edge(contact, _reach(contact)),
		_line_handle.at(),
		_line_handle.at().negated(),
		flight.start.position,
		flight.start.position.minus(rim),
		flight.start.position.plus(rim),
	]
	for point in points:
		places.append(board.to_screen(point))
	if _ledger.visible and _ledger.get_parent() == board:
		for share: float in [0.1, 0.5, 0.9]:
			for down: float in [0.0, 0.5, 1.0]:
				places.append(_ledger.position + _ledger.size * Vector2(share, down))
	return places
