class_name DotProductModel
extends LessonModel
## Two vectors in the plane, and the shadow of one on the other.
##
## Each vector has a tail and a head, in units; what is computed depends on head minus tail alone.

# A dot product, or a length minus 1, of at most this share of its terms is rounding.
const _ROUNDING := 1.0 / 2.0 ** 50

## Presets by their titles (source text): what each changes in the model's state.
const PRESETS: Dictionary[String, Dictionary] = {
	"Lecture": {a = [7, 1], a_from = [0, 0], b = [8, -6], b_from = [0, 0]},
	"Right angle": {a = [4, 3], a_from = [0, 0], b = [6, -8], b_from = [0, 0]},
	"Obtuse": {a = [-5, 2], a_from = [0, 0], b = [8, -6], b_from = [0, 0]},
	"Huge": {a = [4e15, 3e15], a_from = [0, 0], b = [6e15, -8e15], b_from = [0, 0]},
	"Zero": {a = [7, 1], a_from = [0, 0], b = [0, 0], b_from = [0, 0]},
}

## Tail and head of vector a. The lesson's scene holds where both vectors lie at the start.
var a_tail := Vec2.new()
var a_head := Vec2.new()
## Tail and head of vector b.
var b_tail := Vec2.new()
var b_head := Vec2.new()
## False projects a on b, true b on a.
var is_swapped := false
## False makes the usual mistake: the vector projected on is not brought to length 1 first.
var normalizes := true


## The tails and heads of both.
func ends() -> Array[Vec2]:
	return [a_tail, a_head, b_tail, b_head]


## Vector a: head minus tail.
func a() -> Vec2:
	return a_head.minus(a_tail)


## Vector b: head minus tail.
func b() -> Vec2:
	return b_head.minus(b_tail)


## The vector whose shadow is looked for.
func shadowed() -> Vec2:
	return b() if is_swapped else a()


## The vector on which the shadow falls.
func onto() -> Vec2:
	return a() if is_swapped else b()


## Where the vector that is projected on begins.
func onto_tail() -> Vec2:
	return a_tail if is_swapped else b_tail


## Where the vector whose shadow is looked for begins.
func shadowed_tail() -> Vec2:
	return b_tail if is_swapped else a_tail


## Where the vector whose shadow is looked for ends.
func shadowed_head() -> Vec2:
	return b_head if is_swapped else a_head


## a . b = ax bx + ay by, in square units.
func dot() -> float:
	return a().dot(b())


## Whether [method dot] is 0 but for rounding.
func is_dot_zero() -> bool:
	var terms := absf(a().x * b().x) + absf(a().y * b().y)
	return absf(dot()) <= _ROUNDING * terms


## The angle between both vectors in degrees, 0..180; 0 if one of them is zero.
func angle_degrees() -> float:
	return absf(signed_angle_degrees())


## The angle from [method onto] to [method shadowed] in degrees, in (-180, 180], from the x to
## screen.
func signed_angle_degrees() -> float:
	return Vec2.rad_to_deg(onto().angle_to(shadowed()))


## The cosine of the angle between both: the dot product of their unit vectors; 0 if one is zero.
func cosine() -> float:
	return a().normalized().dot(b().normalized())


## The vector of length 1 along [method onto]; zero where that is zero.
func unit() -> Vec2:
	return onto().normalized()


## The scalar projection as the switch [member normalizes] has it: right, or |onto| times too big.
func scalar_projection() -> float:
	return shadowed().scalar_projection(onto()) if normalizes else dot()


## The vector projection as the switch has it: scalar times unit vector, or times the vector as it
## is.
func vector_projection() -> Vec2:
	if normalizes:
		return shadowed().vector_projection(onto())
	return onto().scaled(dot())


## What the shadow leaves over, on screen “the rest”: [method shadowed] minus
## [method vector_projection].
func rejection() -> Vec2:
	return shadowed().minus(vector_projection())


## Whether [method rejection] is zero but for rounding: both vectors lie along the same line.
func leaves_nothing() -> bool:
	var parts := shadowed().length() + vector_projection().length()
	return rejection().length() <= _ROUNDING * parts


## Whether both vectors are equally long but for rounding: then both shadows are.
func has_equal_lengths() -> bool:
	return absf(a().length() - b().length()) <= _ROUNDING * a().length()


## The length of the other shadow with its sign, that of [method onto] on [method shadowed]; 0 where
## that is zero.
func other_scalar_projection() -> float:
	return onto().scalar_projection(shadowed())


## The other shadow.
func other_vector_projection() -> Vec2:
	return onto().vector_projection(shadowed())


## The foot of the perpendicular from [param point] on the line along [method onto].
func foot(point: Vec2) -> Vec2:
	return onto_tail().plus(point.minus(onto_tail()).vector_projection(onto()))


## Where the right shadow ends; null where there is none.
func shadow_end() -> Vec2:
	var has_shadow := onto().length() > 0.0 and shadowed().length() > 0.0
	return foot(shadowed_head()) if has_shadow else null


## Whether [method scalar_projection] is another one than the right one: without normalizing, unless
## a length of 1 or a right angle hides the mistake.
func is_wrong() -> bool:
	var is_unit := absf(onto().length() - 1.0) <= _ROUNDING
	return not normalizes and not is_dot_zero() and not is_unit


## Whether the shadow ends where [method onto] ends, but for rounding.
func ends_at_head() -> bool:
	var length := onto().length()
	return absf(shadowed().scalar_projection(onto()) - length) < 1e-9 * length


## The same for the other shadow and [method shadowed].
func other_ends_at_head() -> bool:
	var length := shadowed().length()
	return absf(other_scalar_projection() - length) < 1e-9 * length


## -1, 0 or 1: the sign of the dot product tells an angle above, at or below 90 degrees. 0 also
## where only rounding is left.
func side() -> int:
	return 0 if is_dot_zero() else int(signf(dot()))


## Turns the shadowed vector about its tail until it makes [param degrees] with the other, as
## [method signed_angle_degrees] counts; its length stays.
func set_signed_angle_degrees(degrees: float) -> void:
	var turned := shadowed()
	turned.set_angle_degrees(onto().angle_degrees() + degrees)
	var head := shadowed_tail().plus(turned)
	if is_swapped:
		b_head = head
	else:
		a_head = head


## Takes a component of a or b; the tail stays where it is.
func enter(name_in_line: String, value: float) -> String:
	match name_in_line:
		"ax":
			a_head.x = a_tail.x + value
		"ay":
			a_head.y = a_tail.y + value
		"bx":
			b_head.x = b_tail.x + value
		"by":
			b_head.y = b_tail.y + value
	return ""


## All of it, for undo and links: heads, and where they begin.
func to_dictionary() -> Dictionary:
	return {
		"a": PackedFloat64Array([a_head.x, a_head.y]),
		"a_from": PackedFloat64Array([a_tail.x, a_tail.y]),
		"b": PackedFloat64Array([b_head.x, b_head.y]),
		"b_from": PackedFloat64Array([b_tail.x, b_tail.y]),
		"is_swapped": is_swapped,
		"normalizes": normalizes,
	}


## Puts back what [method to_dictionary] has told.
func from_dictionary(stored: Dictionary) -> void:
	_put(stored, "a", a_head)
	_put(stored, "a_from", a_tail)
	_put(stored, "b", b_head)
	_put(stored, "b_from", b_tail)
	is_swapped = stored["is_swapped"]
	normalizes = stored["normalizes"]


static func _put(stored: Dictionary, name: String, point: Vec2) -> void:
	var numbers: PackedFloat64Array = stored[name]
	point.set_xy(numbers[0], numbers[1])
