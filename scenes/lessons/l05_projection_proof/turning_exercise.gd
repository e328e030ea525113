class_name TurningExercise
extends Exercise
## Asks for one line of the proof with fresh whole numbers.
##
## b is a multiple of a Pythagorean triple, so that its length is whole and answers are short.

## What is asked for: the turned b, cosine and sine of its angle, or x of the turned a.
enum Kind { TURNED_A, COSINE_AND_SINE, TURNED_B }

const _TRIPLES: Array[Vector2i] = [
	Vector2i(3, 4), Vector2i(4, 3), Vector2i(6, 8), Vector2i(8, 6), Vector2i(12, 5)
]

# What the lecture's own vectors are good for; their a′ = (5, 5) has equal components.
const _OF_THE_LECTURE: Array[Kind] = [Kind.COSINE_AND_SINE, Kind.TURNED_B]

## The vector whose shadow is looked for.
var a: Vec2
## The vector on which it falls; its length is a whole number.
var b: Vec2

var _kind: Kind


## A question with the vectors [param a_vector] and [param b_vector].
func _init(kind: Kind, a_vector: Vec2, b_vector: Vec2) -> void:
	_kind = kind
	a = a_vector
	b = b_vector
	match kind:
		Kind.TURNED_A:
			_ask_turned_a()
		Kind.COSINE_AND_SINE:
			_ask_cosine_and_sine()
		Kind.TURNED_B:
			_ask_turned_b()


## A question with vectors drawn from [param rng], neither of them zero nor along an axis.
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> TurningExercise:
	var triple := _TRIPLES[rng.randi_range(0, _TRIPLES.size() - 1)]
	var onto := Vec2.new(triple.x * _random_sign(rng), triple.y * _random_sign(rng))
	var shadowed := Vec2.new(
		rng.randi_range(1, 9) * _random_sign(rng), rng.randi_range(1, 9) * _random_sign(rng)
	)
	return new(kind, shadowed, onto)


## The question with the lecture's own vectors; null where two answers would be the same.
static func of_the_lecture(kind: Kind) -> TurningExercise:
	if not kind in _OF_THE_LECTURE:
		return null
	return new(kind, Vec2.new(7.0, 1.0), Vec2.new(8.0, -6.0))


func solution() -> String:
	var length := NumberText.short(b.length())
	var right := text_of(right_answer)
	match _kind:
		Kind.COSINE_AND_SINE:
			return _solution_of_triangle(length)
		Kind.TURNED_B:
			return "b′ = (|b|, 0) = %s" % right
	var factors := [a.x, b.x, a.y, b.y].map(NumberText.factor)
	return "a′.x = a · b̂ = (%s·%s + %s·%s) / %s = %s" % (factors + [length, right])


func _solution_of_triangle(length: String) -> String:
	var cosine := [NumberText.factor(b.x), length, NumberText.short(right_answer[0])]
	var sine := [NumberText.factor(b.y), length, NumberText.short(right_answer[1])]
	return "cos β = bx / |b| = %s / %s = %s, sin β = by / |b| = %s / %s = %s" % (cosine + sine)


func board_state() -> Dictionary:
	return {"a": PackedFloat64Array([a.x, a.y]), "b": PackedFloat64Array([b.x, b.y])}


static func _random_sign(rng: RandomNumberGenerator) -> int:
	return 1 if rng.randi_range(0, 1) == 1 else -1


func _ask_turned_a() -> void:
	var question := tr("a = %s and b = %s are turned until b lies on the x axis. What is a′.x?")
	prompt = question % [NumberText.pair(a.x, a.y), NumberText.pair(b.x, b.y)]
	answer_titles = ["a′.x ="]
	right_answer = [a.scalar_projection(b)]
	var size := b.length()
	_add([a.dot(b)], _not_divided(size))
	_add([-a.dot(b)], tr("The sign is wrong, and it is not divided by |b|."))
	_add([(a.x * b.x - a.y * b.y) / size], tr("Turned the wrong way: by β instead of −β."))
	_add([-a.dot(b) / size], tr("The sign is wrong: unlike signs make a product negative."))
	_add([-b.cross(a) / size], tr("The sign is wrong, and that is a′.y."))
	_add([b.cross(a) / size], tr("That is a′.y, the rest. Asked is a′.x, the shadow."))
	_add(
		[(a.x * b.y + a.y * b.x) / size],
		tr("Cosine and sine are swapped: cos β = bx / |b|, sin β = by / |b|.")
	)
	_add([a.length()], tr("That is |a|. Turning keeps the length of a, not its x."))
	_add([a.x], tr("That is the x of a before the turn."))


func _ask_cosine_and_sine() -> void:
	var question := tr("b = %s has the angle β. What are cos β and sin β?")
	prompt = question % NumberText.pair(b.x, b.y)
	answer_titles = ["cos β =", "sin β ="]
	var unit := b.normalized()
	right_answer = [unit.x, unit.y]
	var swapped := tr("Swapped: the cosine belongs to x, the sine to y.")
	for sign_of_x: float in [1.0, -1.0]:
		for sign_of_y: float in [1.0, -1.0]:
			_add([sign_of_x * unit.y, sign_of_y * unit.x], swapped)
	_add([b.x, b.y], _not_divided(b.length()))
	_add([unit.x, -unit.y], tr("The sine has the sign of by, also where y points down."))
	_add([-unit.x, unit.y], tr("The cosine has the sign of bx."))
	_add([-unit.x, -unit.y], tr("Both signs are wrong: they are those of bx and by."))


func _ask_turned_b() -> void:
	var question := tr("b = %s is turned by −β. Where does its head lie then?")
	prompt = question % NumberText.pair(b.x, b.y)
	answer_titles = ["b′.x =", "b′.y ="]
	var size := b.length()
	right_answer = [size, 0.0]
	_add([1.0, 0.0], tr("That is the turned unit vector. Turning keeps the length of b."))
	for side: float in [1.0, -1.0]:
		_add([0.0, side * size], tr("That is on the y axis: b turns to the x axis."))
	var twice := 2.0 * b.angle_radians()
	var wrong_way := tr("Turned the wrong way: by β instead of −β.")
	_add([size * cos(twice), size * sin(twice)], wrong_way)
	_add([b.x, 0.0], tr("That is the shadow of b on the x axis. Turning keeps the length."))
	if b.x < 0.0:
		_add([-b.x, 0.0], tr("That is a shadow on the x axis. Turning keeps the length."))
	_add([b.x, -b.y], tr("That is b mirrored at the x axis, not turned."))
	_add([-size, 0.0], tr("The other way round: b points along the x axis, not against it."))
	_add([b.length_squared(), 0.0], tr("That is |b|²: the root is missing."))


func _not_divided(size: float) -> String:
	var sentence := tr("Not divided by |b|: that is %s times too big.")
	return sentence % NumberText.short(size)


func _add(answer: PackedFloat64Array, sentence: String) -> void:
	add_mistake(answer, sentence)
