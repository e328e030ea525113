class_name ExactParabola
extends RefCounted
## The path of a ball under constant acceleration to about 100 bits. It decides what doubles cannot,
## such as whether a ball that nearly grazes a line touches it.
##
## All arguments are taken as exact. Numbers and their products must be 0 or have a magnitude
## between 1e-140 and 1e140.

var _px: DoubleDouble
var _py: DoubleDouble
var _vx: DoubleDouble
var _vy: DoubleDouble
var _gx: DoubleDouble
var _gy: DoubleDouble


## The path of a centre that starts at (px, py), in pixels, with the velocity (vx, vy) in px/s and
## the acceleration (gx, gy) in px/s².
func _init(px: float, py: float, vx: float, vy: float, gx: float, gy: float) -> void:
	_px = DoubleDouble.from_float(px)
	_py = DoubleDouble.from_float(py)
	_vx = DoubleDouble.from_float(vx)
	_vy = DoubleDouble.from_float(vy)
	_gx = DoubleDouble.from_float(gx)
	_gy = DoubleDouble.from_float(gy)


## The distance of the start from the line through (ax, ay) and (bx, by), on the side [param side]
## (1 or -1), less [param reach]; all times the length of the segment. A negative reach stands for
## the other edge of the strip.
func line_gap(ax: float, ay: float, bx: float, by: float, reach: float, side: float) -> float:
	return _line_gap(ax, ay, bx, by, reach, side).to_float()


## The discriminant of the quadratic for the times at which the distance from the line is
## [param reach]: climb² - 2 pull gap, each times the length of the segment as in [method line_gap].
func line_discriminant(
	ax: float, ay: float, bx: float, by: float, reach: float, side: float
) -> float:
	var ex := DoubleDouble.sum_of(bx, -ax)
	var ey := DoubleDouble.sum_of(by, -ay)
	var climb := ex.times(_vy).minus(ey.times(_vx))
	var pull := ex.times(_gy).minus(ey.times(_gx)).times(DoubleDouble.from_float(2.0 * side))
	var gap := _line_gap(ax, ay, bx, by, reach, side)
	return climb.times(climb).minus(pull.times(gap)).to_float()


## The squared distance from (cx, cy) less radius², in px², after [param seconds].
func squared_gap(cx: float, cy: float, radius: float, seconds: float) -> float:
	var dx := _at(_px, _vx, _gx, seconds).minus(DoubleDouble.from_float(cx))
	var dy := _at(_py, _vy, _gy, seconds).minus(DoubleDouble.from_float(cy))
	var squared := dx.times(dx).plus(dy.times(dy))
	return squared.minus(DoubleDouble.product_of(radius, radius)).to_float()


## Half the rate of change of [method squared_gap], in px²/s: the dot product of the velocity and
## the vector from (cx, cy).
func growth(cx: float, cy: float, seconds: float) -> float:
	var dx := _at(_px, _vx, _gx, seconds).minus(DoubleDouble.from_float(cx))
	var dy := _at(_py, _vy, _gy, seconds).minus(DoubleDouble.from_float(cy))
	var time := DoubleDouble.from_float(seconds)
	var ux := _vx.plus(_gx.times(time))
	var uy := _vy.plus(_gy.times(time))
	return dx.times(ux).plus(dy.times(uy)).to_float()


func _line_gap(
	ax: float, ay: float, bx: float, by: float, reach: float, side: float
) -> DoubleDouble:
	var ex := DoubleDouble.sum_of(bx, -ax)
	var ey := DoubleDouble.sum_of(by, -ay)
	var dx := _px.minus(DoubleDouble.from_float(ax))
	var dy := _py.minus(DoubleDouble.from_float(ay))
	var height := ex.times(dy).minus(ey.times(dx)).times(DoubleDouble.from_float(side))
	var length := ex.times(ex).plus(ey.times(ey)).square_root()
	return height.minus(length.times(DoubleDouble.from_float(reach)))


func _at(
	place: DoubleDouble, velocity: DoubleDouble, acceleration: DoubleDouble, seconds: float
) -> DoubleDouble:
	var time := DoubleDouble.from_float(seconds)
	var half := DoubleDouble.from_float(0.5 * seconds)
	return place.plus(velocity.plus(acceleration.times(half)).times(time))
