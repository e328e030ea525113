class_name ProjectionProofModel
extends LessonModel
## Two vectors from the origin that are turned together until the second lies on the x axis.
##
## The turn is by -beta, beta being the angle of b. While it is under way, a share of it is carried
## out. Components in units, angles in radians.

## Presets by their titles (source text): what each changes in the model's state.
const PRESETS: Dictionary[String, Dictionary] = {
	"Lecture": {a = [7.0, 1.0], b = [8.0, -6.0]},
	"One bit": {a = [5.0, 1.0], b = [3.0, 4.0]},
	"Obtuse": {a = [-5.0, 2.0], b = [8.0, -6.0]},
	"Right angle": {a = [3.0, 4.0], b = [8.0, -6.0]},
	"Zero": {a = [7.0, 1.0], b = [0.0, 0.0]},
}

# A side of the proof of at most this share of a is rounding: a few units in the last place of a.
const _ROUNDING := 1.0 / 2.0 ** 48

## The vector whose shadow is looked for.
var a := Vec2.new(7.0, 1.0)
## The vector on which the shadow falls.
var b := Vec2.new(8.0, -6.0)
## The share of the turn by -beta that has been carried out, 0..1; other values are clamped.
var turned_share := 1.0:
	set(value):
		turned_share = clampf(value, 0.0, 1.0)


## Whether b has a direction. A zero vector has none, and there is nothing to prove.
func has_direction() -> bool:
	return b.length() > 0.0


## The angle of b from the x axis, in (-PI, PI].
func beta() -> float:
	return b.angle_radians()


## How far both have been turned, in radians: the share of beta, which on the way is the angle that
## is shown.
func turned_by() -> float:
	return _turn(turned_share)


## [param vector] as it lies now, after the share of the turn.
func turned(vector: Vec2) -> Vec2:
	return _after_share(vector, turned_share)


## [param vector] after the whole turn.
func fully_turned(vector: Vec2) -> Vec2:
	return _after_share(vector, 1.0)


## cos beta, from the triangle of b: bx / |b|. 0 for a zero b.
func cosine() -> float:
	return b.normalized().x


## sin beta, from the triangle of b: by / |b|. 0 for a zero b.
func sine() -> float:
	return b.normalized().y


## The vector projection of a on b, before any turn.
func projection() -> Vec2:
	return a.vector_projection(b)


## One side of the proof: x of a after the whole turn. 0 for a zero b.
func x_of_turned_a() -> float:
	return fully_turned(a).x if has_direction() else 0.0


## The other side: a . unit(b), as the lecture writes it. 0 for a zero b.
func dot_with_unit() -> float:
	return a.dot(b.normalized())


## Lets a end at [param head].
func set_a(head: Vec2) -> void:
	a = head.copy()


## Lets b end at [param head].
func set_b(head: Vec2) -> void:
	b = head.copy()


## Takes the number that has this name in the formula: `ax`, `ay`, `bx` or `by`.
func enter(name_in_line: String, value: float) -> String:
	var vector := a if name_in_line[0] == "a" else b
	if name_in_line[1] == "x":
		vector.x = value
	else:
		vector.y = value
	return ""


## Gives a the value for which its head is at [param head] after the share of the turn.
func set_turned_a(head: Vec2) -> void:
	a = head.copy()
	a.rotate_radians(-turned_by())


## Makes b so long that, after the share of the turn, it ends at the foot of the perpendicular from
## [param head]. Its direction stays; where the foot is behind its tail, b stays as it was.
func set_reach_of_turned_b(head: Vec2) -> void:
	var reach := head.scalar_projection(turned(b))
	if reach > 0.0:
		b.set_length(reach)


## x of a after the share of the turn that is given: what the graph shows.
func x_at_share(share: float) -> float:
	return _after_share(a, share).x


## The distance between both sides of the proof, in units in the last place.
func units_apart() -> float:
	return LastPlace.units_between(x_of_turned_a(), dot_with_unit())


## Whether both sides are 0 but for rounding: the angle between a and b is 90 degrees.
func is_rounding() -> bool:
	var largest := maxf(absf(x_of_turned_a()), absf(dot_with_unit()))
	return largest <= _ROUNDING * a.length()


## The heads before and after the whole turn, so that the board does not change during it.
func points_to_show() -> Array[Vec2]:
	# A little more than the turned b reaches, so that its label stays clear of that of the axis.
	var beyond := fully_turned(b).scaled(1.12)
	return [a, b, fully_turned(a), beyond]


## All of it that the student sets, for undo and links.
func to_dictionary() -> Dictionary:
	return {"a": PackedFloat64Array([a.x, a.y]), "b": PackedFloat64Array([b.x, b.y])}


## Puts back what [method to_dictionary] has told.
func from_dictionary(stored: Dictionary) -> void:
	var of_a: PackedFloat64Array = stored["a"]
	var of_b: PackedFloat64Array = stored["b"]
	a.set_xy(of_a[0], of_a[1])
	b.set_xy(of_b[0], of_b[1])


func _after_share(vector: Vec2, share: float) -> Vec2:
	var result := vector.copy()
	result.rotate_radians(_turn(share))
	return result


# At the end a full turn more would change nothing but the last bit.
func _turn(share: float) -> float:
	var is_longer := Conventions.has_full_turn() and beta() < 0.0 and share < 1.0
	return -(beta() + TAU if is_longer else beta()) * share
