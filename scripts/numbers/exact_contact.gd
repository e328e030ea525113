class_name ExactContact
extends RefCounted
## Where on its path a ball's centre is exactly [code]radius[/code] away from an infinite line, to
## about 100 bits: what position reset and point of impact are compared with.
##
## The path leads straight from the old to the new position, both taken as exact; their distances
## from the line must differ.


## The share of the path up to the contact: (old - r) / (old - new) with the exact distances. Beyond
## 0..1 the contact is on the path made longer.
static func share(
	old_position: Vec2, new_position: Vec2, radius: float, line: LineSegment
) -> DoubleDouble:
	var old_distance := ExactLineDistance.signed_distance(old_position, line)
	var new_distance := ExactLineDistance.signed_distance(new_position, line)
	var way_to_contact := old_distance.minus(DoubleDouble.from_float(radius))
	return way_to_contact.divided(old_distance.minus(new_distance))


## How many pixels [param position] is from the contact on the path.
static func distance_from(
	position: Vec2, old_position: Vec2, new_position: Vec2, radius: float, line: LineSegment
) -> float:
	var time := share(old_position, new_position, radius, line)
	var contact_x := _on_path(old_position.x, new_position.x, time)
	var contact_y := _on_path(old_position.y, new_position.y, time)
	return Vec2.new(contact_x.error_of(position.x), contact_y.error_of(position.y)).length()


static func _on_path(from: float, to: float, time: DoubleDouble) -> DoubleDouble:
	return DoubleDouble.from_float(from).plus(DoubleDouble.sum_of(to, -from).times(time))
