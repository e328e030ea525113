class_name ExactImpactFraction
## The fraction of the frame before an impact, to about 100 bits: what the readout compares the
## lecture's formulas with.
##
## The coordinates, as doubles, are taken as exact. Coordinates up to 1e6, as in [LineEndsModel].


## The first root of the quadratic for a ball and a point; null where there is none.
static func with_point(from: Vec2, motion: Vec2, radius: float, point: Vec2) -> DoubleDouble:
	var across := DoubleDouble.sum_of(from.x, -point.x)
	var down := DoubleDouble.sum_of(from.y, -point.y)
	var x := DoubleDouble.from_float(motion.x)
	var y := DoubleDouble.from_float(motion.y)
	var a := x.times(x).plus(y.times(y))
	var half_b := across.times(x).plus(down.times(y))
	var c := across.times(across).plus(down.times(down))
	c = c.minus(DoubleDouble.product_of(radius, radius))
	var quarter_discriminant := half_b.times(half_b).minus(a.times(c))
	if a.high == 0.0 or quarter_discriminant.high < 0.0:
		return null
	var zero := DoubleDouble.from_float(0.0)
	return zero.minus(half_b).minus(quarter_discriminant.square_root()).divided(a)


## The fraction at which a ball touches the infinite line on the side where it begins; null where
## it moves along the line.
static func with_line(from: Vec2, motion: Vec2, radius: float, line: LineSegment) -> DoubleDouble:
	var along_x := DoubleDouble.sum_of(line.end.x, -line.start.x)
	var along_y := DoubleDouble.sum_of(line.end.y, -line.start.y)
	var across := DoubleDouble.sum_of(from.x, -line.start.x)
	var down := DoubleDouble.sum_of(from.y, -line.start.y)
	# Distances times the length of the line: the determinant of both vectors.
	var old_distance := along_x.times(down).minus(along_y.times(across))
	var x := DoubleDouble.from_float(motion.x)
	var y := DoubleDouble.from_float(motion.y)
	var approach := along_y.times(x).minus(along_x.times(y))
	if approach.high == 0.0:
		return null
	var length := along_x.times(along_x).plus(along_y.times(along_y)).square_root()
	var side := -1.0 if old_distance.high < 0.0 else 1.0
	var touching := length.times(DoubleDouble.from_float(radius * side))
	return old_distance.minus(touching).divided(approach)
