class_name ProjectionExercise
extends Exercise
## Asks for a dot product, a scalar projection or a vector projection of two whole-number vectors,
## or for a scalar projection the primitive way, by angles.
##
## b is a multiple of (3, 4), so that its length is whole and answers have two decimals at most. By
## angles a has an even length and b is 60 or 120 degrees away.

## What is asked for.
enum Kind { DOT, SCALAR, VECTOR, PRIMITIVE }

# Multiples of the Pythagorean triple 3, 4, 5: other triples, such as 5, 12, 13, give endless
# decimals.
const _TRIPLES: Array[Vector2i] = [
	Vector2i(3, 4), Vector2i(4, 3), Vector2i(6, 8), Vector2i(8, 6), Vector2i(9, 12), Vector2i(12, 9)
]

## The vector whose shadow is asked for.
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
		Kind.DOT:
			_ask_dot()
		Kind.SCALAR:
			_ask_scalar()
		Kind.VECTOR:
			_ask_vector()
		Kind.PRIMITIVE:
			_ask_primitive()


## A question with vectors drawn from [param rng], neither of them zero nor along an axis.
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> ProjectionExercise:
	if kind == Kind.PRIMITIVE:
		return _fresh_angles(rng)
	var triple := _TRIPLES[rng.randi_range(0, _TRIPLES.size() - 1)]
	var onto := Vec2.new(triple.x * _random_sign(rng), triple.y * _random_sign(rng))
	var shadowed := Vec2.new(
		rng.randi_range(1, 9) * _random_sign(rng), rng.randi_range(1, 9) * _random_sign(rng)
	)
	return new(kind, shadowed, onto)


## The question with the lecture's own vectors.
static func of_the_lecture(kind: Kind) -> ProjectionExercise:
	return new(kind, Vec2.new(7.0, 1.0), Vec2.new(8.0, -6.0))


func solution() -> String:
	var dot := NumberText.short(a.dot(b))
	var length := NumberText.short(b.length())
	var scalar := NumberText.short(a.scalar_projection(b))
	match _kind:
		Kind.DOT:
			var factors := [a.x, b.x, a.y, b.y].map(NumberText.factor)
			return "a · b = %s·%s + %s·%s = %s" % (factors + [dot])
		Kind.SCALAR:
			return "a · b̂ = a · b / |b| = %s / %s = %s" % [dot, length, scalar]
		Kind.PRIMITIVE:
			var phi := NumberText.short(_shown(a) - _shown(b))
			var numbers := [NumberText.short(a.length()), phi, text_of(right_answer)]
			return "|a| cos(α − β) = %s·cos %s° = %s" % numbers
	var unit := b.normalized()
	var pairs := [NumberText.pair(unit.x, unit.y), text_of(right_answer)]
	return "p = (a · b̂) b̂ = %s %s = %s" % ([scalar] + pairs)


func board_state() -> Dictionary:
	# Vectors that are given by their angles have endless decimals.
	if not is_zero_approx(fposmod(a.x, 1.0)):
		return {}
	return {a = [a.x, a.y], a_from = [0, 0], b = [b.x, b.y], b_from = [0, 0]}


static func _fresh_angles(rng: RandomNumberGenerator) -> ProjectionExercise:
	var beta := 5.0 * rng.randi_range(-12, 12)
	var apart := 60.0 * rng.randi_range(1, 2) * _random_sign(rng)
	var shadowed := Vec2.unit_degrees(beta + apart).scaled(2.0 * rng.randi_range(1, 9))
	return new(Kind.PRIMITIVE, shadowed, Vec2.unit_degrees(beta).scaled(10.0))


static func _random_sign(rng: RandomNumberGenerator) -> int:
	return 1 if rng.randi_range(0, 1) == 1 else -1


func _ask_dot() -> void:
	_ask(tr("a = %s, b = %s. What is the dot product a · b?"), ["a · b ="], [a.dot(b)])
	var subtracted := tr("The products are added, not subtracted: ax bx + ay by.")
	_add([a.x * b.x - a.y * b.y], subtracted)
	_add([a.y * b.y - a.x * b.x], subtracted)
	_add([a.x * b.y + a.y * b.x], tr("x goes with x, and y with y: ax bx + ay by."))
	_add([a.cross(b)], tr("That is the determinant ax by − ay bx, not the dot product."))
	_add([b.cross(a)], tr("That is the determinant ay bx − ax by, not the dot product."))
	_add(
		[a.scalar_projection(b)], tr("That is the scalar projection: a · b is not divided by |b|.")
	)
	_add([-a.dot(b)], tr("The sign is wrong: unlike signs make a product negative."))


func _ask_scalar() -> void:
	var right := a.scalar_projection(b)
	_ask(tr("a = %s, b = %s. What is the scalar projection of a on b?"), ["a · b̂ ="], [right])
	_add([a.dot(b)], _not_normalized())
	_add([-a.dot(b)], tr("The sign is wrong, and b was not normalized."))
	_add([right / b.length()], tr("Divided by |b| twice: a · b / |b| is enough for the scalar."))
	_add([b.scalar_projection(a)], tr("That is b on a: a · b̂ is not b · â."))
	_add([-right], tr("The sign is wrong: negative beyond 90°, positive below."))
	_add([a.length()], tr("That is |a|: the shadow is shorter, unless both are parallel."))
	var distance := tr("That is the distance from the line: the rest, not the shadow.")
	_add([a.cross(b) / b.length()], distance)
	_add([b.cross(a) / b.length()], distance)


func _ask_vector() -> void:
	var right := a.vector_projection(b)
	var question := tr("a = %s, b = %s. What is the vector projection p of a on b?")
	_ask(question, ["px =", "py ="], [right.x, right.y])
	_add_vector(b.scaled(a.dot(b)), _not_normalized_twice())
	_add_vector(b.scaled(a.scalar_projection(b)), _not_normalized())
	_add_vector(b.vector_projection(a), tr("That is b on a: p must be parallel to b."))
	_add_vector(a.rejection(b), tr("That is the rest a − p: it is perpendicular to b."))
	_add_vector(a.rejection(b).negated(), tr("That is p − a: it is perpendicular to b."))
	_add_vector(right.negated(), tr("p points the other way: mind the sign of a · b."))


func _ask_primitive() -> void:
	var alpha := a.angle_degrees()
	var beta := b.angle_degrees()
	var length := a.length()
	# But for rounding.
	var right := snappedf(a.scalar_projection(b), 1e-9)
	var asked := tr(
		"|a| = %s, its angle is α = %s°, that of b is β = %s°. What is the scalar projection of a on b?"
	)
	var numbers := [length, _shown(a), _shown(b)]
	prompt = asked % numbers.map(func(x: float) -> String: return NumberText.short(x))
	answer_titles = ["|a| cos(α − β) ="]
	right_answer = [right]
	_add([-right], tr("The sign is wrong: negative beyond 90°, positive below."))
	_add([length * cos(Vec2.deg_to_rad(alpha))], tr("That is |a| cos α: take β off first."))
	_add([length * cos(Vec2.deg_to_rad(alpha + beta))], tr("α − β, not α + β."))
	var distance := tr("That is the distance from the line: the rest, not the shadow.")
	add_mistake_of_either_sign([a.cross(b) / b.length()], distance)
	_add([right / length], tr("That is cos(α − β): it still has to be multiplied by |a|."))
	_add([right * b.length()], tr("That is a · b: the scalar projection is |a| cos(α − β)."))


# The angle of a vector as the lab shows it.
static func _shown(vector: Vec2) -> float:
	return Conventions.in_range(vector.angle_degrees())


func _not_normalized() -> String:
	var sentence := tr("b was not normalized: that is |b| = %s times too big.")
	return sentence % NumberText.short(b.length())


func _not_normalized_twice() -> String:
	var sentence := tr("b was not normalized, in two places: that is |b|² = %s times too big.")
	return sentence % NumberText.short(b.length_squared())


func _ask(question: String, titles: PackedStringArray, answer: PackedFloat64Array) -> void:
	prompt = question % [NumberText.pair(a.x, a.y), NumberText.pair(b.x, b.y)]
	answer_titles = titles
	right_answer = answer


func _add(answer: PackedFloat64Array, sentence: String) -> void:
	add_mistake(answer, sentence)


func _add_vector(answer: Vec2, sentence: String) -> void:
	add_mistake([answer.x, answer.y], sentence)
