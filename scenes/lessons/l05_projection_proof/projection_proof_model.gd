class_name ProjectionProofModel
extends RefCounted
## Two vectors from the origin that are turned together until the second lies on the x axis.
##
## The turn is by -beta, beta being the angle of b. It can be carried out in part: that is what the
## drawing shows on its way. Components in units, angles in radians.

## The vector whose shadow is looked for.
var a := Vec2.new(7.0, 1.0)
## The vector on which the shadow falls.
var b := Vec2.new(8.0, -6.0)
## How much of the turn by -beta has been carried out, from 0 to 1.
var turned_share := 1.0:
	set(value):
		turned_share = clampf(value, 0.0, 1.0)


## Whether b has a direction. A zero vector has none, and there is nothing to prove.
func has_direction() -> bool:
	return b.length() > 0.0


## The angle of b, clockwise on screen from the x axis, in (-PI, PI].
func beta() -> float:
	return b.angle_radians()


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


## Takes the a whose head is at [param head] after the share of the turn.
func set_turned_a(head: Vec2) -> void:
	a = head.copy()
	a.rotate_radians(beta() * turned_share)


## Makes b so long that after the share of the turn it reaches the shadow of [param head] on it; its
## direction stays. A head behind the tail is not taken.
func set_reach_of_turned_b(head: Vec2) -> void:
	var reach := head.scalar_projection(turned(b))
	if reach > 0.0:
		b.set_length(reach)


## x of a after the share of the turn that is given: what the graph shows.
func x_at_share(share: float) -> float:
	return _after_share(a, share).x


## How far both sides of the proof are apart, in units in the last place.
func units_apart() -> float:
	return LastPlace.units_between(x_of_turned_a(), dot_with_unit())


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
	result.rotate_radians(-beta() * share)
	return result
