class_name GripExercise
extends Exercise
## Asks for the slip, for the least friction that lets a ball stick, for the ball after the contact,
## for the spin with which it hops straight up, and for the ball that another one throws.

## What is asked for.
enum Kind { SLIP, MARK, AFTER, STRAIGHT_UP, THROW }

# Tangents of contacts of two balls, in tenths: a ball that flies to the right comes to them.
const _TANGENTS: Array[Vector2i] = [
	Vector2i(6, -8), Vector2i(8, -6), Vector2i(-6, -8), Vector2i(-8, -6)
]

## The contact that is asked about.
var contact: FrictionContact

var _velocity: Vec2
var _along: PackedFloat64Array


## A question about a ball with [param velocity] and [param spin] that comes to a surface along
## [param along] with the friction [param friction]; of the kind THROW it is the tangent of two
## balls.
func _init(kind: Kind, velocity: Vec2, spin: float, friction: float, along: Vec2) -> void:
	var radius := 20.0
	var other := Ball.new(Vec2.zero(), radius) if kind == Kind.THROW else null
	var ball := Ball.new(Vec2.zero(), radius, velocity, 1.0, spin)
	contact = FrictionContact.new(ball, along, 1.0, friction, other)
	_velocity = velocity
	_along = [along.x, along.y]
	match kind:
		Kind.SLIP:
			_ask_slip()
		Kind.MARK:
			_ask_mark()
		Kind.AFTER:
			_ask_after()
		Kind.STRAIGHT_UP:
			_ask_straight_up()
		Kind.THROW:
			_ask_throw()


## A question with numbers drawn from [param rng].
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> GripExercise:
	if kind == Kind.THROW:
		var tenths := _TANGENTS[rng.randi_range(0, _TANGENTS.size() - 1)]
		var speed := 50.0 * rng.randi_range(2, 8)
		var usual: PackedFloat64Array = [0.1, 0.2, 0.3]
		var tangent := Vec2.new(tenths.x, tenths.y).scaled(7.5)
		return new(kind, Vec2.new(speed, 0.0), 0.0, usual[rng.randi_range(0, 2)], tangent)
	var along := 60.0 * rng.randi_range(1, 6)
	var down := 100.0 * rng.randi_range(2, 5)
	var spin := 0.0
	if kind == Kind.SLIP:
		spin = 3.0 * rng.randi_range(1, 6) * (1.0 if rng.randi_range(0, 1) else -1.0)
	var frictions: PackedFloat64Array = [0.05, 0.1, 0.25, 0.5]
	var friction: float = frictions[rng.randi_range(0, 3)]
	return new(kind, Vec2.new(along, down), spin, friction, Vec2.new(100.0, 0.0))


## The question with the numbers of the course.
static func of_the_lecture(kind: Kind) -> GripExercise:
	if kind == Kind.THROW:
		return new(kind, Vec2.new(250.0, 0.0), 0.0, 0.2, Vec2.new(45.0, -60.0))
	var spin := -30.0 if kind == Kind.SLIP else 0.0
	return new(kind, Vec2.new(300.0, 400.0), spin, 0.25, Vec2.new(100.0, 0.0))


## The contact on the board.
func board_state() -> Dictionary:
	return {
		"velocity": PackedFloat64Array([_velocity.x, _velocity.y]),
		"spin": contact.ball.spin,
		"along": _along,
		"friction": contact.friction,
		"bounciness": 1.0,
		"radius": contact.ball.radius,
		"gravity": 0.0,
		"two_balls": contact.other != null,
		"has_friction": true,
	}


func _ask_slip() -> void:
	prompt = _given() + " " + tr("How large is the slip u?")
	answer_titles = ["u ="]
	var along := contact.along_speed()
	var rim := contact.ball.radius * contact.ball.spin
	right_answer = [contact.slip()]
	add_mistake([along + rim], tr("The sign of r ω: where it touches, the rim runs back."))
	add_mistake([along], tr("That is the flight alone: the rim rubs, too."))
	add_mistake([along - contact.ball.spin], tr("ω is no speed yet: the rim has r ω."))
	add_mistake([rim - along], tr("That is −u: the flight less the rim."))
	add_mistake([_velocity.length() - rim], tr("Only the part of v along the surface rubs: v · t."))


func _ask_mark() -> void:
	prompt = _given_without_friction() + " " + tr("From which µ on do the surfaces stick?")
	answer_titles = ["µ ="]
	var slip := absf(contact.slip())
	right_answer = [slip / 3.0 / contact.push()]
	add_mistake(
		[slip / contact.push()],
		tr("A third of the slip is enough: friction brakes the flight and turns the ball.")
	)
	add_mistake([slip / 2.0 / contact.push()], tr("That is a ring's mark. A disc has a third."))
	add_mistake(
		[2.0 * slip / 3.0 / contact.push()], tr("The push is (1 + C) times the speed along n.")
	)
	add_mistake(
		[contact.push() / 3.0 / slip], tr("Upside down: µ times the push must reach u / 3.")
	)


func _ask_after() -> void:
	var friction := NumberText.short(contact.friction)
	prompt = (
		_given_without_friction() + " " + tr("µ = %s. What are v · t and ω afterwards?") % friction
	)
	answer_titles = ["v′ · t =", "ω′ ="]
	var right := contact.after()
	right_answer = _along_and_spin(right)
	var slip := contact.slip()
	_add_grip(-slip / 2.0, tr("That is a ring: it takes half of the slip. A disc takes a third."))
	_add_grip(-slip / 3.0, tr("Friction is too weak for that: it is at most µ jn."))
	for info in CollisionFrictionMistakes.infos():
		_add_new(
			_along_and_spin(CollisionFrictionMistakes.balls_after(info.number, contact)),
			info.sentence
		)
	_add_grip(0.0, tr("That is without friction."))
	var swapped := right[0].spin
	_add_new([right_answer[0], -swapped], tr("The sign of ω′: friction turns it as it would roll."))


func _ask_straight_up() -> void:
	var sentence := tr("Which spin ω lets it hop straight up, if the surfaces stick?")
	prompt = _given_without_friction() + " " + sentence
	answer_titles = ["ω ="]
	var along := contact.along_speed()
	var radius := contact.ball.radius
	right_answer = [-2.0 * along / radius]
	add_mistake([2.0 * along / radius], tr("That is topspin: it would hop off even faster."))
	add_mistake(
		[-along / radius], tr("That leaves a third of v · t: friction takes a third of the slip.")
	)
	add_mistake([-2.0 * along], tr("That is r ω: divide by the radius."))
	add_mistake([-3.0 * along / radius], tr("u must be 3 v · t, and u is v · t − r ω."))
	add_mistake([along / radius], tr("That is the spin of a ball that rolls: nothing would rub."))


func _ask_throw() -> void:
	var sentence := tr("A ball with v₁ = %s hits an equal one at rest; n = %s, C = 1, µ = %s.")
	var numbers := [
		NumberText.pair(_velocity.x, _velocity.y),
		NumberText.pair(contact.normal.x, contact.normal.y),
		NumberText.short(contact.friction)
	]
	prompt = sentence % numbers + " " + tr("What is v₂′?")
	answer_titles = ["x", "y"]
	var right := contact.after()
	right_answer = _pair(right[1].velocity)
	var smooth := contact.after_with(0.0, 0.0)[1].velocity
	add_mistake(
		_pair(smooth), tr("The ball that is hit does not leave along n: friction throws it.")
	)
	var throw := right[1].velocity.minus(smooth)
	add_mistake(
		_pair(smooth.minus(throw)), tr("The throw is to the other side: friction drags it along u.")
	)
	add_mistake(_pair(right[0].velocity), tr("That is v₁′, of the ball that came."))
	add_mistake(_pair(right[1].velocity.scaled(2.0)), tr("That is all of J: each ball takes half."))
	add_mistake(
		_pair(right[1].velocity.negated()), tr("That is + J / 2: ball 2 is pushed against n.")
	)


# What would be with this impulse along the surface, which turns the ball, too.
func _add_grip(grip: float, sentence: String) -> void:
	_add_new(_along_and_spin(contact.after_with(grip, grip)), sentence)


# A mistake that changes nothing here, or has the answer of another one, is left out.
func _add_new(answer: PackedFloat64Array, sentence: String) -> void:
	var is_new := not _same(answer, right_answer)
	for mistake in mistakes:
		is_new = is_new and not _same(answer, mistake.answer)
	if is_new:
		add_mistake(answer, sentence)


func _along_and_spin(balls: Array[Ball]) -> PackedFloat64Array:
	return [balls[0].velocity.dot(contact.tangent), balls[0].spin]


static func _pair(vector: Vec2) -> PackedFloat64Array:
	return [vector.x, vector.y]


func _given() -> String:
	var sentence := tr("A disc with v = %s, ω = %s, r = %s comes to a level floor, t = (1, 0).")
	return sentence % _numbers()


func _given_without_friction() -> String:
	var sentence := tr(
		"A disc without spin, v = %s, r = %s, comes to a level floor, C = 1, t = (1, 0)."
	)
	var numbers := _numbers()
	return sentence % [numbers[0], numbers[2]]


func _numbers() -> Array[String]:
	return [
		NumberText.pair(_velocity.x, _velocity.y),
		NumberText.short(contact.ball.spin),
		NumberText.short(contact.ball.radius)
	]
