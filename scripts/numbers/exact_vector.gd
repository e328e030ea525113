class_name ExactVector
extends RefCounted
## A vector with about 106 bits in each component, for [ExactPath]. It never changes: every
## operation returns a new one. The range is that of [DoubleDouble].

## The horizontal component, to the right, in pixels or pixels per second.
var x: DoubleDouble
## The vertical component, downwards, in the same unit.
var y: DoubleDouble


## A vector with these components.
func _init(x_component: DoubleDouble, y_component: DoubleDouble) -> void:
	x = x_component
	y = y_component


## Both components with all their digits.
func _to_string() -> String:
	return "(%s, %s)" % [x, y]


## The same vector, exactly.
static func from_vec2(vector: Vec2) -> ExactVector:
	return ExactVector.new(DoubleDouble.from_float(vector.x), DoubleDouble.from_float(vector.y))


## The vector from one point to another, without any rounding.
static func between(from: Vec2, to: Vec2) -> ExactVector:
	return ExactVector.new(DoubleDouble.sum_of(to.x, -from.x), DoubleDouble.sum_of(to.y, -from.y))


## The sum of this vector and [param other].
func plus(other: ExactVector) -> ExactVector:
	return ExactVector.new(x.plus(other.x), y.plus(other.y))


## This vector minus [param other].
func minus(other: ExactVector) -> ExactVector:
	return ExactVector.new(x.minus(other.x), y.minus(other.y))


## This vector times [param factor].
func scaled(factor: DoubleDouble) -> ExactVector:
	return ExactVector.new(x.times(factor), y.times(factor))


## (-y, x): turned by +90 degrees and as long as before, exactly.
func turned() -> ExactVector:
	return ExactVector.new(y.negated(), x)


## The dot product.
func dot(other: ExactVector) -> DoubleDouble:
	return x.times(other.x).plus(y.times(other.y))


## The vector reflected off a line whose normal is [param normal], of any length above 0:
## v - 2 (v . n) / (n . n) n.
func reflected(normal: ExactVector) -> ExactVector:
	var times := dot(normal).divided(normal.dot(normal))
	return minus(normal.scaled(times.plus(times)))


## The nearest vector of doubles.
func to_vec2() -> Vec2:
	return Vec2.new(x.to_float(), y.to_float())
