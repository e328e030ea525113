class_name BounceExercise
extends Exercise
## Asks for one step of the easy bounce, or for the shortest distance from a tilted line.
##
## The tilted line runs along a Pythagorean triple, so that the answer is a short decimal.

## What is asked for.
enum Kind { PUT_BACK, FLIP, SHORTEST }

const _TRIPLES: Array[Vector3i] = [Vector3i(4, 3, 5), Vector3i(12, 5, 13), Vector3i(15, 8, 17)]

var _kind: Kind
# Each kind uses some of these.
var _floor_y: float
var _radius: float
var _velocity: Vec2
var _slope: Vector3i
var _straight: float


## A question with the numbers that [method fresh] draws.
func _init(kind: Kind, floor_y: float, radius: float, velocity: Vec2, slope: Vector3i) -> void:
	_kind = kind
	_floor_y = floor_y
	_radius = radius
	_velocity = velocity.copy()
	_slope = slope
	# A multiple of the hypotenuse, so that the shortest distance is whole.
	_straight = 2.0 * slope.z
	match kind:
		Kind.PUT_BACK:
			_ask_put_back()
		Kind.FLIP:
			_ask_flip()
		Kind.SHORTEST:
			_ask_shortest()


## A question with whole numbers drawn from [param rng].
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> BounceExercise:
	var floor_y := 10.0 * rng.randi_range(5, 20)
	var radius := 4.0 * rng.randi_range(5, 11)
	var across := rng.randi_range(1, 9)
	var velocity := Vec2.new(across, (across + rng.randi_range(1, 8) - 1) % 9 + 1)
	var slope := _TRIPLES[rng.randi_range(0, _TRIPLES.size() - 1)]
	return new(kind, floor_y, radius, velocity, slope)


func solution() -> String:
	var right := text_of(right_answer)
	match _kind:
		Kind.PUT_BACK:
			var numbers := [NumberText.short(_floor_y), NumberText.short(_radius), right]
			return "y = %s − r = %s − %s = %s" % ([tr("floor")] + numbers)
		Kind.FLIP:
			return "v = (vx, −vy) = %s" % right
	return (
		tr("Along the perpendicular: %s px")
		% (
			"%s·%d / √(%d² + %d²) = %s"
			% [NumberText.short(_straight), _slope.x, _slope.x, _slope.y, right]
		)
	)


## Puts what is asked about on the board of [param model].
func set_up(model: EasyBounceModel) -> void:
	if model.is_wall:
		model.swap_axes()
	model.rewind()
	model.tilt_degrees = 0.0
	model.pivot = Vec2.new()
	match _kind:
		Kind.PUT_BACK:
			model.pivot = Vec2.new(0.0, _floor_y)
			model.ball = Ball.new(
				Vec2.new(0.0, _floor_y - _radius / 2.0), _radius, model.ball.velocity
			)
		Kind.FLIP:
			model.ball = Ball.new(Vec2.new(0.0, -36.0), 60.0, _velocity.scaled(4.0))
		Kind.SHORTEST:
			model.tilt_degrees = Vec2.rad_to_deg(atan2(_slope.y, _slope.x))
			model.ball = Ball.new(Vec2.new(0.0, -_straight), 60.0, model.ball.velocity)


func _ask_put_back() -> void:
	var texts := [NumberText.short(_floor_y), NumberText.short(_radius)]
	prompt = (
		tr("Floor at y = %s, radius %s, y down. The ball has sunk in: to which y is it put back?")
		% texts
	)
	_ask_for(["y ="], [_floor_y - _radius])
	add_mistake([_floor_y], tr("Then its centre lies on the floor: take the radius off."))
	add_mistake([_floor_y + _radius], tr("y points down: above the floor is floor − r."))
	add_mistake([_radius - _floor_y], tr("The sign is wrong: floor − r, not r − floor."))


func _ask_flip() -> void:
	var text := NumberText.pair(_velocity.x, _velocity.y)
	prompt = tr("A ball hits a level floor with v = %s. What is v after the bounce?") % text
	_ask_for(["vx =", "vy ="], [_velocity.x, -_velocity.y])
	add_mistake([_velocity.x, _velocity.y], tr("That is v before: it goes on into the floor."))
	add_mistake(
		[-_velocity.x, -_velocity.y],
		tr("Both are flipped: the ball flies back where it came from.")
	)
	add_mistake([-_velocity.x, _velocity.y], tr("x is for an upright wall; a floor flips y."))
	add_mistake([_velocity.x, 0.0], tr("Then it would slide along: y changes its sign."))


func _ask_shortest() -> void:
	var texts := [_slope.x, _slope.y, NumberText.short(_straight)]
	prompt = (
		tr(
			"A line has the direction (%d, %d). Straight down it is %s px to it. And the shortest way?"
		)
		% texts
	)
	_ask_for(["px:"], [_straight * _slope.x / _slope.z])
	add_mistake([_straight], tr("That is straight down; the perpendicular is shorter."))
	add_mistake(
		[_straight * _slope.y / _slope.z],
		tr("That is how far the foot lies along the line: take the other one.")
	)
	add_mistake(
		[_straight * _slope.z / _slope.x], tr("Longer than straight down? Times, not divided.")
	)


func _ask_for(titles: PackedStringArray, answer: PackedFloat64Array) -> void:
	answer_titles = titles
	right_answer = answer
