class_name ExactParabola
extends RefCounted
## The path of a ball under constant acceleration to about 100 bits: settles what plain numbers
## cannot, such as whether a ball that nearly grazes a line touches it.
##
## Every number handed in is taken as exact. Numbers and their products must be 0 or have a
## magnitude between 1e-140 and 1e140.

var _px: DoubleDouble
var _py: DoubleDouble
var _vx: DoubleDouble
var _vy: DoubleDouble
var _gx: DoubleDouble
var _gy: DoubleDouble


## A centre at (px, py) in pixels with the velocity (vx, vy) in px/s and the acceleration (gx, gy)
## in px/s².
func _init(px: float, py: float, vx: float, vy: float, gx: float, gy: float) -> void:
	_px = DoubleDouble.from_float(px)
	_py = DoubleDouble.from_float(py)
	_vx = DoubleDouble.from_float(vx)
	_vy = DoubleDouble.from_float(vy)
	_gx = DoubleDouble.from_float(gx)
	_gy = DoubleDouble.from_float(gy)


## By how much the start is farther than [param reach] from the line through (ax, ay) and (bx, by),
## seen from the side [param side] (1 or -1; a negative reach means the other edge of the strip),
## times the length of the segment.
func line_gap(ax: float, ay: float, bx: float, by: float, reach: float, side: float) -> float:
	return _line_gap(ax, ay, bx, by, reach, side).to_float()


## The discriminant of the times at which the distance from the line is [param reach]:
## climb² - 2 pull gap, each times the length of the segment as in [method line_gap].
func line_discriminant(
	ax: float, ay: float, bx: float, by: float, reach: float, side: float
) -> float:
	var ex := DoubleDouble.sum_of(bx, -ax)
	var ey := DoubleDouble.sum_of(by, -ay)
	var climb := ex.times(_vy).minus(ey.times(_vx))
	var pull := ex.times(_gy).minus(ey.times(_gx)).times(DoubleDouble.from_float(2.0 * side))
	var gap := _line_gap(ax, ay, bx, by, reach, side)
	return climb.times(climb).minus(pull.times(gap)).to_float()


## Squared distance from (cx, cy) less radius², in px², after [param seconds].
func squared_gap(cx: float, cy: float, radius: float, seconds: float) -> float:
	var dx := _at(_px, _vx, _gx, seconds).minus(DoubleDouble.from_float(cx))
	var dy := _at(_py, _vy, _gy, seconds).minus(DoubleDouble.from_float(cy))
	var squared := dx.times(dx).plus(dy.times(dy))
	return squared.minus(DoubleDouble.product_of(radius, radius)).to_float()


## Half of how fast [method squared_gap] grows, in px²/s: the velocity times the way from (cx, cy).
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
