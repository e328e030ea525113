class_name CapExercise
extends Exercise
## Asks about a ball that meets the end of a line, with fresh whole numbers: the discriminant, the
## fraction of the frame before the impact, or the normal.
##
## The ball touches at a Pythagorean triple from the end, so that the root is a whole number.

## What is asked for.
enum Kind { FRACTION, DISCRIMINANT, NORMAL }

const _TRIPLES: Array[Vector2i] = [
	Vector2i(3, 4), Vector2i(4, 3), Vector2i(6, 8), Vector2i(8, 6), Vector2i(5, 12), Vector2i(12, 5)
]
const _FRACTIONS: Array[float] = [0.25, 0.5, 0.75]

## From the end of the line to the ball's centre at the beginning of the frame.
var difference: Vec2
## The motion of the frame.
var motion: Vec2
## The ball's radius.
var radius: float
## The quadratic for the end and the ball.
var equation: CapEquation

var _solution := ""


## A question on a ball of [param with_radius] whose centre begins at [param from] as seen from the
## end of the line and moves by [param by].
func _init(kind: Kind, from: Vec2, by: Vec2, with_radius: float) -> void:
	difference = from
	motion = by
	radius = with_radius
	equation = CapEquation.new(from, by, with_radius, Vec2.new())
	match kind:
		Kind.FRACTION:
			_ask_fraction()
		Kind.DISCRIMINANT:
			_ask_discriminant()
		Kind.NORMAL:
			_ask_normal()


## A question with numbers drawn from [param rng]: the ball touches the end at a quarter, a half or
## three quarters of the frame.
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> CapExercise:
	var triple := _TRIPLES[rng.randi_range(0, _TRIPLES.size() - 1)]
	var touch := Vec2.new(triple.x * _random_sign(rng), triple.y * _random_sign(rng))
	var fraction := _FRACTIONS[rng.randi_range(0, _FRACTIONS.size() - 1)]
	var by := Vec2.new(4 * rng.randi_range(-3, 3), 4 * rng.randi_range(-3, 3))
	# A motion that does not approach the end would not touch it: draw another.
	while by.dot(touch) >= 0.0:
		by = Vec2.new(4 * rng.randi_range(-3, 3), 4 * rng.randi_range(-3, 3))
	return new(kind, touch.minus(by.scaled(fraction)), by, touch.length())


func solution() -> String:
	return _solution


## Lays the numbers of the question into [param model], with the line behind its end.
func lay(model: LineEndsModel) -> void:
	var touch := difference.plus(motion.scaled(equation.first_root()))
	model.start = difference.copy()
	model.motion = motion.copy()
	model.radius = radius
	model.segment = LineSegment.new(Vec2.new(), touch.scaled(-2.0))
	model.fraction = 1.0


static func _random_sign(rng: RandomNumberGenerator) -> int:
	return 1 if rng.randi_range(0, 1) == 1 else -1


func _ask_fraction() -> void:
	_ask(tr("At which share t of the frame does it touch the end?"), ["t ="])
	right_answer = [equation.first_root()]
	_solution = (
		tr("t = (−b − √D) / (2 a) = (%s − %s) / %s = %s.")
		% _texts([-equation.b, sqrt(equation.discriminant()), 2.0 * equation.a, right_answer[0]])
	)
	var d := equation.discriminant()
	add_mistake([equation.second_root()], tr("That is t₂, the way out. The first touch is t₁."))
	add_mistake([(-equation.b - d * d) / (2.0 * equation.a)], tr("D was squared: take its root."))
	add_mistake([(-equation.b - d) / (2.0 * equation.a)], tr("The root of D is missing."))
	add_mistake(
		[equation.first_root() - 1.0],
		tr("Counted from the new position: count from where the frame begins.")
	)
	add_mistake(
		[(-equation.b - sqrt(d)) / equation.a], tr("Divided by a: it must be divided by 2a.")
	)
	add_mistake(
		[-equation.b / (2.0 * equation.a)],
		tr("That is the time of the closest approach: the root of D is missing.")
	)
	add_mistake([-equation.first_root()], tr("The sign is wrong: −b, and b is negative here."))
	add_mistake([-equation.second_root()], tr("d goes from the end to the ball, not back."))


func _ask_discriminant() -> void:
	_ask(tr("What is the discriminant D = b² − 4ac?"), ["D ="])
	var a := equation.a
	var b := equation.b
	right_answer = [equation.discriminant()]
	_solution = (
		tr("a = v · v = %s, b = 2 d · v = %s, c = d · d − r² = %s: D = b² − 4 a c = %s.")
		% _texts([a, b, equation.c, right_answer[0]])
	)
	add_mistake([sqrt(equation.discriminant())], tr("That is the root of D already."))
	add_mistake([b * b + 4.0 * a * equation.c], tr("4ac is taken away, not added."))
	add_mistake(
		[b * b - 4.0 * a * (equation.c + radius * radius)],
		tr("c is d · d − r²: the radius is missing. That is the centre hitting the end.")
	)
	add_mistake([b * b / 4.0 - 4.0 * a * equation.c], tr("b is 2 d · v: the factor 2 is missing."))
	add_mistake(
		[b * b - 4.0 * a * (equation.c + radius * radius - radius)],
		tr("c is d · d − r²: r was not squared.")
	)
	add_mistake([equation.discriminant() / 4.0], tr("That is D / 4: b is 2 d · v."))


func _ask_normal() -> void:
	var fraction := equation.first_root()
	_ask(
		tr("It touches at t = %s. What is the unit normal n̂?") % NumberText.short(fraction),
		["n̂x =", "n̂y ="]
	)
	var touch := difference.plus(motion.scaled(fraction))
	var normal := touch.normalized()
	right_answer = [normal.x, normal.y]
	_solution = (
		tr("At the touch the ball is at %s: divided by r = %s, that is %s.")
		% [
			NumberText.pair(touch.x, touch.y),
			NumberText.short(radius),
			NumberText.pair(normal.x, normal.y),
		]
	)
	add_mistake(
		[-normal.x, -normal.y], tr("n̂ points from the end to the ball, not the other way.")
	)
	_add_both_ways(touch, tr("That is not of length 1 yet: divide it by r."))
	_add_both_ways(
		difference.normalized(), tr("That is at the start: take the ball where it touches.")
	)
	_add_both_ways(
		motion.normal(), tr("That is perpendicular to v: n̂ goes from the end to the ball.")
	)
	_add_both_ways(normal.normal(), tr("That is the normal of the normal: 90° too far."))
	_add_both_ways(difference.plus(motion).normalized(), tr("That is after the frame, not at t."))


func _ask(question: String, titles: PackedStringArray) -> void:
	var given := tr("A line ends at (0, 0). A ball, r = %s, starts at %s and moves by v = %s.")
	prompt = (
		(
			given
			% [
				NumberText.short(radius),
				NumberText.pair(difference.x, difference.y),
				NumberText.pair(motion.x, motion.y),
			]
		)
		+ " "
		+ question
	)
	answer_titles = titles


static func _texts(numbers: PackedFloat64Array) -> Array[String]:
	var texts: Array[String] = []
	for number in numbers:
		texts.append(NumberText.short(number))
	return texts


# Students take the difference of ball and end, and a normal, in either direction.
func _add_both_ways(answer: Vec2, sentence: String) -> void:
	add_mistake_of_either_sign([answer.x, answer.y], sentence)
