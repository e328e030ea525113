class_name ExactBank
extends RefCounted
## The direction of a bank shot to about 100 bits: the exact answer for readouts.
##
## The numbers are taken as exact. They must be 0 or have a magnitude between 1e-140 and 1e140.


## How far [param direction], of length 1, is from the exact one for the shot over [param walls], in
## the order of the bounces and on these [param sides], as [BankWay] has them. For the other
## parameters see [BankAim]. 0 where start and image are one point.
static func error_of_direction(
	direction: Vec2,
	start: Vec2,
	target: Vec2,
	radius: float,
	bounciness: float,
	walls: Array[LineSegment],
	sides: PackedFloat64Array
) -> float:
	var image := ExactVector.between(start, target)
	for place in range(walls.size() - 1, -1, -1):
		image = _mirrored(image, start, radius, bounciness, walls[place], sides[place])
	var length := image.dot(image).square_root()
	if length.high == 0.0:
		return 0.0
	var x := image.x.divided(length).error_of(direction.x)
	var y := image.y.divided(length).error_of(direction.y)
	return Vec2.new(x, y).length()


# The image of a point in the wall that is moved by the radius to its side, both counted from the
# start: p - (1 + 1/C) (n . (p - a) - r) n, with n = N / |N|.
static func _mirrored(
	point: ExactVector,
	start: Vec2,
	radius: float,
	bounciness: float,
	wall: LineSegment,
	side: float
) -> ExactVector:
	var normal := ExactVector.between(wall.start, wall.end).turned()
	normal = normal.scaled(DoubleDouble.from_float(side))
	var length := normal.dot(normal).square_root()
	var from_wall := point.minus(ExactVector.between(start, wall.start))
	var height := normal.dot(from_wall).divided(length).minus(DoubleDouble.from_float(radius))
	var one := DoubleDouble.from_float(1.0)
	var times := one.plus(one.divided(DoubleDouble.from_float(bounciness)))
	return point.minus(normal.scaled(times.times(height).divided(length)))
