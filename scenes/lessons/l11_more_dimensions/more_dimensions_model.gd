class_name MoreDimensionsModel
extends LessonModel
## Two vectors of three, four or five components, and the one dot product that serves them all.

## What the sign of the dot product says of the angle.
enum Side { OBTUSE = -1, RIGHT = 0, ACUTE = 1 }

## Presets by their titles (source text): what each changes in the model's state.
const PRESETS: Dictionary[String, Dictionary] = {
	"Acute": {a = [4, -3, 2, 1], b = [2, -4, -1, 3]},
	"Right angle": {a = [4, -3, 2, 1], b = [1, -2, -5, 0]},
	"Obtuse": {a = [4, -3, 2, 1], b = [-3, 2, 1, -4]},
	"Flat": {a = [7, 1, 0, 0], b = [8, -6, 0, 0]},
}

## This many components are kept; with fewer, the last ones do not count.
const MOST := 5
## So many of them are the lists a and b in a link; what is behind them has a name of its own there.
const IN_LISTS := 4
## No component is larger in size than this, so that products stay exact enough to be compared.
const LARGEST := 1e6
## No component but 0 is smaller in size than this.
const SMALLEST := 1e-6
## Degrees: a smaller angle between two vectors is rounding.
const LEAST_ANGLE := 1e-13

## The components of both vectors, in units; always [constant MOST] of them.
var a: PackedFloat64Array = [4.0, -3.0, 2.0, 1.0, 3.0]
var b: PackedFloat64Array = [2.0, -4.0, -1.0, 3.0, -2.0]
## True for four components, false for three.
var has_four := false
## True for five components.
var has_five := false
## From where the three axes are looked at.
var view := Axonometry.new()


## How many components count: 3, 4 or 5.
func dimension() -> int:
	if has_five:
		return MOST
	return 4 if has_four else 3


## Whether there are more components than a picture in space has axes.
func is_beyond_space() -> bool:
	return dimension() > 3


## The components of a that count.
func counted_a() -> PackedFloat64Array:
	return a.slice(0, dimension())


## The components of b that count.
func counted_b() -> PackedFloat64Array:
	return b.slice(0, dimension())


## a . b, in square units.
func dot() -> float:
	return ComponentLists.dot(counted_a(), counted_b())


## What each component adds to the dot product, in square units.
func products() -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	for i in dimension():
		found.append(a[i] * b[i])
	return found


## The length of a, in units.
func length_of_a() -> float:
	return ComponentLists.length(counted_a())


## The length of b, in units.
func length_of_b() -> float:
	return ComponentLists.length(counted_b())


## The cosine of the angle, -1..1; 0 where one of the vectors is zero and there is no angle.
func cosine() -> float:
	var lengths := length_of_a() * length_of_b()
	return dot() / lengths if lengths > 0.0 else 0.0


## The cosine to about 100 bits; null where there is no angle.
func exact_cosine() -> DoubleDouble:
	var squares := ComponentLists.exact_dot(counted_a(), counted_a())
	squares = squares.times(ComponentLists.exact_dot(counted_b(), counted_b()))
	if squares.high == 0.0:
		return null
	return ComponentLists.exact_dot(counted_a(), counted_b()).divided(squares.square_root())


## The angle between both in degrees, 0..180; 90 where there is none. It is not the arc cosine,
## which keeps only half of the digits near 0 and 180.
func angle_degrees() -> float:
	if side() == Side.RIGHT:
		return 90.0
	var apart: PackedFloat64Array = []
	var together: PackedFloat64Array = []
	for i in dimension():
		var of_a := a[i] / length_of_a()
		var of_b := b[i] / length_of_b()
		apart.append(of_a - of_b)
		together.append(of_a + of_b)
	var half := atan2(ComponentLists.length(apart), ComponentLists.length(together))
	return _without_rounding(Vec2.rad_to_deg(2.0 * half))


# Parallel vectors make no angle of 1e-14 degrees.
static func _without_rounding(degrees: float) -> float:
	if degrees < LEAST_ANGLE:
		return 0.0
	return 180.0 if degrees > 180.0 - LEAST_ANGLE else degrees


## The sum of the sizes of the products, in square units.
func size_of_products() -> float:
	var sum := 0.0
	for product in products():
		sum += absf(product)
	return sum


## Whether the angle is acute, right or obtuse, by the sign of the dot product alone. What rounding
## leaves of it counts as 0.
func side() -> Side:
	var is_rounding := absf(dot()) <= size_of_products() / 2.0 ** 50
	return (0 if is_rounding else int(signf(dot()))) as Side


## Whether there is an angle: a zero vector makes none.
func has_angle() -> bool:
	return length_of_a() > 0.0 and length_of_b() > 0.0


## The first three components of the shadow of a on b; zero for a zero b.
func shadow() -> PackedFloat64Array:
	var first_b := b.slice(0, 3)
	var square := ComponentLists.dot(first_b, first_b)
	var share := ComponentLists.dot(a.slice(0, 3), first_b) / square if square > 0.0 else 0.0
	return [b[0] * share, b[1] * share, b[2] * share]


## Takes a typed number by its name in the formula, such as `a1`. "" if it was taken; else one
## sentence with the value and what is allowed, and nothing changes.
func enter(name_in_line: String, value: float) -> String:
	return set_component(name_in_line[0], name_in_line.substr(1).to_int() - 1, value)


## Puts [param value] into a component, counted from 0, of the vector [param letter], `a` or `b`.
## "" if it was taken; else one sentence with the value and what is allowed, and nothing changes.
func set_component(letter: String, index: int, value: float) -> String:
	var size := absf(value)
	if size > LARGEST or (size < SMALLEST and size > 0.0):
		var sentence := TranslationServer.translate(
			"%s cannot be: a component is 0, or from 1e-6 to 1e6 in size."
		)
		return sentence % NumberText.short(value)
	if letter == "a":
		a[index] = value
	else:
		b[index] = value
	return ""


func to_dictionary() -> Dictionary:
	return {
		"a": a.slice(0, IN_LISTS),
		"b": b.slice(0, IN_LISTS),
		"fifth": PackedFloat64Array([a[-1], b[-1]]),
		"has_four": has_four,
		"has_five": has_five,
		"view": PackedFloat64Array([view.yaw, view.pitch]),
	}


func problem_in(stored: Dictionary) -> String:
	var model := MoreDimensionsModel.new()
	for letter: String in ["a", "b"]:
		var components: PackedFloat64Array = stored[letter]
		for i in components.size():
			var problem := model.set_component(letter, i, components[i])
			if problem:
				return problem
	var fifth: PackedFloat64Array = stored["fifth"]
	for component in fifth:
		var refused := model.set_component("a", MOST - 1, component)
		if refused:
			return refused
	var angles: PackedFloat64Array = stored["view"]
	var steepest := Axonometry.STEEPEST
	return StateCheck.within("view", angles[1], -steepest, steepest)


## The lists in [param stored] may have fewer components than [constant IN_LISTS]: the others stay.
func from_dictionary(stored: Dictionary) -> void:
	var components_of_a: PackedFloat64Array = stored["a"]
	var components_of_b: PackedFloat64Array = stored["b"]
	for i in components_of_a.size():
		a[i] = components_of_a[i]
		b[i] = components_of_b[i]
	var fifth: PackedFloat64Array = stored["fifth"]
	a[-1] = fifth[0]
	b[-1] = fifth[1]
	has_four = stored["has_four"]
	has_five = stored["has_five"]
	var angles: PackedFloat64Array = stored["view"]
	view.yaw = angles[0]
	view.pitch = angles[1]
