class_name NormalExercise
extends Exercise
## Asks for a normal, the opposite one, a unit normal or a scaled one of a whole-number vector.
##
## Where a length is needed, the vector is a multiple of a Pythagorean triple, so that answers are
## short.

## What is asked for.
enum Kind { NORMAL, OPPOSITE, UNIT, SCALED }

## Lengths to which a normal is to be scaled, in pixels; none is the length of a vector asked about.
const _LENGTHS: Array[int] = [30, 40, 50, 60]

# The lecture's own vectors.
const _OF_THE_LECTURE: Dictionary[Kind, Vector2i] = {
	Kind.NORMAL: Vector2i(3, 1), Kind.OPPOSITE: Vector2i(3, -2), Kind.UNIT: Vector2i(3, -4)
}

const _TRIPLES: Array[Vector2i] = [
	Vector2i(3, 4),
	Vector2i(4, 3),
	Vector2i(6, 8),
	Vector2i(8, 6),
	Vector2i(12, 16),
	Vector2i(7, 24)
]

## The vector whose normal is asked for.
var v: Vec2
## The length to which it is to be scaled, in pixels; used by [constant Kind.SCALED].
var wanted_length: float

var _kind: Kind


## A question with the vector [param vector] and the length [param length].
func _init(kind: Kind, vector: Vec2, length: float = 50.0) -> void:
	_kind = kind
	v = vector
	wanted_length = length
	match kind:
		Kind.NORMAL:
			_ask_normal()
		Kind.OPPOSITE:
			_ask_opposite()
		Kind.UNIT:
			_ask_unit()
		Kind.SCALED:
			_ask_scaled()


## A question with a vector drawn from [param rng], neither zero nor along an axis or a diagonal.
static func fresh(kind: Kind, rng: RandomNumberGenerator) -> NormalExercise:
	var size := _TRIPLES[rng.randi_range(0, _TRIPLES.size() - 1)]
	if kind == Kind.NORMAL or kind == Kind.OPPOSITE:
		var x := rng.randi_range(1, 9)
		size = Vector2i(x, (x + rng.randi_range(1, 8) - 1) % 9 + 1)
	var length := _LENGTHS[rng.randi_range(0, _LENGTHS.size() - 1)]
	var vector := Vec2.new(size.x * _random_sign(rng), size.y * _random_sign(rng))
	return new(kind, vector, length)


## The question with the lecture's own vector; null where the lecture asks none of this kind.
static func of_the_lecture(kind: Kind) -> NormalExercise:
	if not _OF_THE_LECTURE.has(kind):
		return null
	return new(kind, Vec2.new(_OF_THE_LECTURE[kind].x, _OF_THE_LECTURE[kind].y))


func solution() -> String:
	var normal := NumberText.pair(-v.y, v.x)
	var length := NumberText.short(v.length())
	var right := text_of(right_answer)
	match _kind:
		Kind.NORMAL:
			return "n = (−y, x) = %s" % right
		Kind.OPPOSITE:
			return "−n = (y, −x) = %s" % right
		Kind.UNIT:
			return "n̂ = n / |n| = %s / %s = %s" % [normal, length, right]
	var wanted := NumberText.short(wanted_length)
	return "%s n̂ = %s %s / %s = %s" % [wanted, wanted, normal, length, right]


static func _random_sign(rng: RandomNumberGenerator) -> int:
	return 1 if rng.randi_range(0, 1) == 1 else -1


func board_state() -> Dictionary:
	return {"line": PackedFloat64Array([0.0, 0.0, v.x, v.y])}


func _ask_normal() -> void:
	prompt = tr("v = %s. What is its normal n, +90° from v?") % NumberText.pair(v.x, v.y)
	_ask_for(["nx =", "ny ="], Vec2.new(-v.y, v.x))
	_add_on_both_sides(v.normal(), tr("That has length 1: n itself is not divided by its length."))
	_add(v, _along_v())
	_add_wrong_directions(1.0)


func _ask_opposite() -> void:
	var asked := tr("v = %s. What is its opposite normal, −90° from v?")
	prompt = asked % NumberText.pair(v.x, v.y)
	_ask_for(["x =", "y ="], Vec2.new(v.y, -v.x))
	_add_on_both_sides(v.normal(), tr("That has length 1: the opposite normal is as long as v."))
	_add(v, tr("That runs along v: turn it by −90°."))
	_add(Vec2.new(-v.y, v.x), tr("That is n, +90° from v: the opposite normal is (y, −x)."))
	_add(Vec2.new(v.y, v.x), tr("(y, x) has no right angle with v: x changes its sign."))
	_add(Vec2.new(-v.y, -v.x), tr("Only x changes its sign: (y, −x), not (−y, −x)."))
	_add(Vec2.new(-v.x, -v.y), tr("That is −v: turned by 180°, not by 90°."))
	_add(Vec2.new(v.x, -v.y), tr("Swap the components, too: (y, −x)."))
	_add(Vec2.new(-v.x, v.y), tr("Swap the components, too: (y, −x)."))


func _ask_unit() -> void:
	prompt = tr("v = %s. What is its unit normal n̂?") % NumberText.pair(v.x, v.y)
	_ask_for(["n̂x =", "n̂y ="], v.normal())
	_add_on_both_sides(Vec2.new(-v.y, v.x), _not_normalized())
	_add(v.normalized(), tr("That is v with length 1: now turn it by +90°."))
	_add_wrong_directions(1.0 / v.length())


func _ask_scaled() -> void:
	var texts := [NumberText.pair(v.x, v.y), NumberText.short(wanted_length)]
	prompt = (
		tr(
			"A line has the direction v = %s. Its normal is drawn %s pixels long. Which vector is that?"
		)
		% texts
	)
	_ask_for(["x =", "y ="], v.normal().scaled(wanted_length))
	_add_on_both_sides(Vec2.new(-v.y, v.x).scaled(wanted_length), _not_normalized())
	_add_on_both_sides(v.normal(), tr("That is 1 pixel long: it still has to be scaled."))
	_add_on_both_sides(
		Vec2.new(-v.y, v.x), tr("That is as long as v: first divide by its length, then scale.")
	)
	_add(v.normalized().scaled(wanted_length), _along_v())
	_add_wrong_directions(wanted_length / v.length())


# What comes out when the length is right and the direction is not: each of these times `factor`.
func _add_wrong_directions(factor: float) -> void:
	var x := v.x * factor
	var y := v.y * factor
	_add(Vec2.new(y, -x), tr("That is the opposite normal (y, −x): −90°."))
	_add(Vec2.new(y, x), tr("(y, x) has no right angle with v: y changes its sign."))
	_add(Vec2.new(-y, -x), tr("Only y changes its sign: (−y, x), not (−y, −x)."))
	_add(Vec2.new(-x, -y), tr("That is −v: turned by 180°, not by 90°."))
	_add(Vec2.new(x, -y), tr("Swap the components, too: (−y, x)."))
	_add(Vec2.new(-x, y), tr("Swap the components, too: (−y, x)."))


func _along_v() -> String:
	return tr("That runs along v: turn it by +90°.")


func _not_normalized() -> String:
	var sentence := tr("Not divided by the length: that is %s times too long.")
	return sentence % NumberText.short(v.length())


func _ask_for(titles: PackedStringArray, answer: Vec2) -> void:
	answer_titles = titles
	right_answer = [answer.x, answer.y]


# The same mistake of those who have chosen the opposite normal.
func _add_on_both_sides(answer: Vec2, sentence: String) -> void:
	add_mistake_of_either_sign([answer.x, answer.y], sentence)


func _add(answer: Vec2, sentence: String) -> void:
	add_mistake([answer.x, answer.y], sentence)
