class_name ExactContact
extends RefCounted
## The point of its path at which a ball's centre is exactly one radius away from an infinite line,
## to about 100 bits. It is the exact answer for position reset and point of impact.
##
## The path is the straight line from the old to the new position, both taken as exact. Their
## distances from the line must differ.


## The fraction of the path up to the contact: (old - r) / (old - new) with the exact distances.
## Outside 0..1 the contact is on the extension of the path.
static func fraction(
	old_position: Vec2, new_position: Vec2, radius: float, line: LineSegment
) -> DoubleDouble:
	var old_distance := ExactLineDistance.signed_distance(old_position, line)
	var new_distance := ExactLineDistance.signed_distance(new_position, line)
	var way_to_contact := old_distance.minus(DoubleDouble.from_float(radius))
	return way_to_contact.divided(old_distance.minus(new_distance))


## The distance in pixels between [param position] and the contact on the path.
static func distance_from(
	position: Vec2, old_position: Vec2, new_position: Vec2, radius: float, line: LineSegment
) -> float:
	var at := fraction(old_position, new_position, radius, line)
	var contact_x := _on_path(old_position.x, new_position.x, at)
	var contact_y := _on_path(old_position.y, new_position.y, at)
	return Vec2.new(contact_x.error_of(position.x), contact_y.error_of(position.y)).length()


static func _on_path(from: float, to: float, at: DoubleDouble) -> DoubleDouble:
	return DoubleDouble.from_float(from).plus(DoubleDouble.sum_of(to, -from).times(at))
