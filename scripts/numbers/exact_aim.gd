class_name ExactAim
extends RefCounted
## By how much a computed time of flight is off, to about 100 bits: for readouts and tests.
##
## A shot hits where |D(t)| = R + s t with D(t) = P + V t + B t²/2; see [BallisticAim]. The computed
## time is put into F(t) = D·D - (R + s t)². What is left of F, by its slope and its bend, is the
## error of the time.


## The error of [param time], in seconds, with its sign: too late is above 0. [param way] leads from
## the shooter to the target, which moves with [param velocity], in px/s, and [param bend], in
## px/s², as the bullet sees it; [param speed] is the bullet's, in px/s, and [param radius] that of
## both discs together. All of them are taken as exact. 0 where the slope and the bend are 0.
static func error_of_time(
	time: float, way: Vec2, velocity: Vec2, bend: Vec2, speed: float, radius: float = 0.0
) -> float:
	var t := DoubleDouble.from_float(time)
	var half := DoubleDouble.from_float(0.5 * time)
	var reach := DoubleDouble.product_of(speed, time).plus(DoubleDouble.from_float(radius))
	var rest := reach.times(reach).negated()
	var slope := -2.0 * speed * reach.to_float()
	var bending := -2.0 * speed * speed
	for axis: String in ["x", "y"]:
		var p: float = way.get(axis)
		var v: float = velocity.get(axis)
		var b: float = bend.get(axis)
		var moving := DoubleDouble.from_float(v).plus(DoubleDouble.from_float(b).times(half))
		var d := DoubleDouble.from_float(p).plus(moving.times(t))
		rest = rest.plus(d.times(d))
		var rate := v + b * time
		slope += 2.0 * d.to_float() * rate
		bending += 2.0 * (rate * rate + d.to_float() * b)
	return _root_near_zero(rest.to_float(), slope, bending)


# The zero of rest - slope x + bending x²/2 next to x = 0: the exact time is x before the computed.
static func _root_near_zero(rest: float, slope: float, bending: float) -> float:
	var inside := maxf(slope * slope - 2.0 * rest * bending, 0.0)
	var divisor := slope + (sqrt(inside) if slope >= 0.0 else -sqrt(inside))
	return 2.0 * rest / divisor if divisor != 0.0 else 0.0
