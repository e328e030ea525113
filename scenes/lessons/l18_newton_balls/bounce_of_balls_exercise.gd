class_name BounceOfBallsExercise
extends Exercise
## Asks what becomes of two balls that meet: their velocities head-on, the impulse, the velocity of
## one that is hit obliquely, the energy that is lost.

## What is asked for.
enum Kind { HEAD_ON, IMPULSE, OBLIQUE, LOST }

# Unit normals with short components.
const _NORMALS: Array[Vector2] = [
	Vector2(0.8, 0.6), Vector2(0.6, 0.8), Vector2(0.8, -0.6), Vector2(0.6, -0.8)
]

## The two balls when they touch.
var meeting: BallMeeting


## A question about this meeting.
func _init(kind: Kind, its_meeting: BallMeeting) -> void:
	meeting = its_meeting
	match kind:
		Kind.HEAD_ON:
			_ask_head_on()
		Kind.IMPULSE:
			_ask_impulse()
		Kind.OBLIQUE:
			_ask_oblique()
		Kind.LOST:
			_ask_lost()


## A question with numbers drawn from [param rng].
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> BounceOfBallsExercise:
	if kind == Kind.OBLIQUE:
		return new(kind, _fresh_oblique(rng))
	var mass_one := rng.randi_range(1, 4)
	var mass_two := rng.randi_range(1, 4)
	var velocity_two := rng.randi_range(-3, 3)
	# The closing speed is a multiple of the total mass: no answer has many digits.
	var closing := (mass_one + mass_two) * rng.randi_range(1, 2)
	var usual: PackedFloat64Array = [0.5, 0.0] if kind == Kind.LOST else [1.0, 0.5, 0.0]
	return new(
		kind,
		_meeting(
			[mass_one, mass_two],
			[Vec2.new(velocity_two + closing, 0.0), Vec2.new(velocity_two, 0.0)],
			Vec2.new(1.0, 0.0),
			usual[rng.randi_range(0, usual.size() - 1)]
		)
	)


static func _fresh_oblique(rng: RandomNumberGenerator) -> BallMeeting:
	var mass_one := rng.randi_range(1, 4)
	var normal := Vec2.from_vector2(_NORMALS[rng.randi_range(0, _NORMALS.size() - 1)])
	normal.set_xy(roundf(normal.x * 10.0) / 10.0, roundf(normal.y * 10.0) / 10.0)
	var across: float = [-5.0, 5.0, 10.0][rng.randi_range(0, 2)]
	var velocity := normal.scaled(5.0).plus(Vec2.new(-normal.y, normal.x).scaled(across))
	velocity.set_xy(roundf(velocity.x), roundf(velocity.y))
	var bounciness := 1.0 if rng.randi_range(0, 1) == 0 else 0.5
	return _meeting([mass_one, 5 - mass_one], [velocity, Vec2.new()], normal, bounciness)


## The question with the numbers of the course.
static func of_the_course(kind: Kind) -> BounceOfBallsExercise:
	if kind == Kind.OBLIQUE:
		var moving: Array[Vec2] = [Vec2.new(5.0, 0.0), Vec2.new()]
		return new(kind, _meeting([1.0, 1.0], moving, Vec2.new(0.8, 0.6), 1.0))
	var velocities: Array[Vec2] = [Vec2.new(6.0, 0.0), Vec2.new()]
	var bounciness := 0.5 if kind == Kind.LOST else 1.0
	return new(kind, _meeting([1.0, 2.0], velocities, Vec2.new(1.0, 0.0), bounciness))


# They touch at the origin.
static func _meeting(
	masses: PackedFloat64Array, velocities: Array[Vec2], normal: Vec2, bounciness: float
) -> BallMeeting:
	var radii: PackedFloat64Array = [
		NewtonBallsModel.radius_of(masses[0]), NewtonBallsModel.radius_of(masses[1])
	]
	var found := BallMeeting.new(
		Ball.new(normal.scaled(-radii[0]), radii[0], velocities[0], masses[0]),
		Ball.new(normal.scaled(radii[1]), radii[1], velocities[1], masses[1]),
		bounciness
	)
	found.normal = normal.copy()
	return found


## The balls one second before they meet.
func board_state() -> Dictionary:
	var balls: Array[PackedFloat64Array] = []
	for ball: Ball in [meeting.one, meeting.two]:
		var start := ball.copy()
		start.position.subtract(ball.velocity)
		balls.append(NewtonBallsModel.list_of(start))
	return {
		"balls": balls,
		"bounciness": meeting.bounciness,
		"has_box": false,
		"has_newton": true,
	}


func solution() -> String:
	var after := meeting.velocities_after()
	var numbers := [NumberText.short(meeting.impulse()), _pair(after[0]), _pair(after[1])]
	var text := "J = %s,  v₁′ = %s,  v₂′ = %s" % numbers
	return text + ",  E − E′ = %s" % NumberText.short(meeting.lost_energy())


func _ask_head_on() -> void:
	prompt = _given_along() + " " + tr("What are v₁′ and v₂′?")
	answer_titles = ["v₁′ =", "v₂′ ="]
	right_answer = _along(meeting.velocities_after())
	_add_wrong_bounces(_along)
	var center := meeting.center_velocity().x
	add_mistake(
		[center, center], tr("That is V for both: they would stick together, as with C = 0.")
	)
	add_mistake([right_answer[1], right_answer[0]], tr("That is v₂′ and v₁′: mind the order."))


func _ask_impulse() -> void:
	prompt = _given_along() + " " + tr("How large is the impulse J that each gives the other?")
	answer_titles = ["J ="]
	right_answer = [meeting.impulse()]
	var mu := meeting.reduced_mass()
	var w := meeting.closing_speed()
	var times := 1.0 + meeting.bounciness
	add_mistake([times * w], tr("The masses are missing: J = (1 + C) m₁ m₂ / (m₁ + m₂) w."))
	add_mistake([mu * w], tr("That is J for C = 0: the factor 1 + C is missing."))
	add_mistake([meeting.bounciness * mu * w], tr("The factor is 1 + C, not C."))
	add_mistake(
		[times * meeting.total_mass() * w], tr("Divide the product of the masses by their sum.")
	)
	add_mistake(
		[times * mu * (meeting.one.velocity.x + meeting.two.velocity.x)],
		tr("w is the difference of the velocities: mind the sign of v₂.")
	)


func _ask_oblique() -> void:
	var numbers := [
		NumberText.short(meeting.one.mass),
		_pair(meeting.one.velocity),
		NumberText.short(meeting.two.mass),
		_pair(meeting.normal),
		NumberText.short(meeting.bounciness)
	]
	prompt = (
		tr("Ball 1 (m₁ = %s, v₁ = %s) hits ball 2 (m₂ = %s, at rest). n = %s, C = %s. What is v₁′?")
		% numbers
	)
	answer_titles = ["x", "y"]
	var after := meeting.velocities_after()
	right_answer = [after[0].x, after[0].y]
	_add_wrong_bounces(func(both: Array[Vec2]) -> PackedFloat64Array: return [both[0].x, both[0].y])
	add_mistake([after[1].x, after[1].y], tr("That is v₂′, the velocity of the other ball."))
	var added := meeting.one.velocity.scaled(2.0).minus(after[0])
	add_mistake([added.x, added.y], tr("Ball 1 is pushed back: against n, not along it."))


func _ask_lost() -> void:
	prompt = _given_along() + " " + tr("How much kinetic energy is lost?")
	answer_titles = ["E − E′ ="]
	right_answer = [meeting.lost_energy()]
	var full := meeting.reduced_mass() * meeting.closing_speed() ** 2 / 2.0
	var c := meeting.bounciness
	add_mistake(
		[(1.0 - c) * full], tr("The factor is 1 − C², because energy goes with the square.")
	)
	add_mistake([c * c * full], tr("That part comes back: 1 − C² of it is lost."))
	add_mistake([2.0 * right_answer[0]], tr("The half is missing: kinetic energy is m v² / 2."))
	add_mistake(
		[(1.0 - c * c) * meeting.energy()],
		tr("Only the energy seen from the centre of mass can be lost: that of V stays.")
	)
	add_mistake(
		[meeting.energy() - right_answer[0]], tr("That is E′, what is left: the loss is asked for.")
	)


# The mistakes of the gallery, as far as they show.
func _add_wrong_bounces(answer_of: Callable) -> void:
	for info in NewtonBallsMistakes.infos():
		var wrong := NewtonBallsMistakes.velocities_after(info.number, meeting)
		var answer: PackedFloat64Array = answer_of.call(wrong)
		var is_new := not _same(answer, right_answer)
		for mistake in mistakes:
			is_new = is_new and not _same(answer, mistake.answer)
		if is_new:
			add_mistake(answer, info.sentence)


static func _along(both: Array[Vec2]) -> PackedFloat64Array:
	return [both[0].x, both[1].x]


func _given_along() -> String:
	var numbers: Array[String] = []
	for ball: Ball in [meeting.one, meeting.two]:
		numbers.append(NumberText.short(ball.mass))
		numbers.append(NumberText.short(ball.velocity.x))
	numbers.append(NumberText.short(meeting.bounciness))
	var sentence := tr("Two balls meet head-on: m₁ = %s, v₁ = %s, m₂ = %s, v₂ = %s, C = %s.")
	return sentence % numbers


static func _pair(vector: Vec2) -> String:
	return NumberText.pair(vector.x, vector.y)
