class_name ExactImpact
extends RefCounted
## The first impact of a ball in straight flight with a two-sided segment with round caps, to about
## 100 bits: the steps of [SegmentImpact] in the arithmetic of [ExactVector].
##
## A ball that touches or overlaps the segment already has its impact at time 0 if it approaches the
## nearest point, and none if it moves away or along.

## Whether there is an impact; without one the other members have no meaning.
var hit := false
## Seconds from now, 0 or more.
var time: DoubleDouble
## The direction from the segment to the ball's centre. Its length is not 1.
var normal: ExactVector


## The impact of a ball at [param position] with the velocity [param velocity] and [param segment],
## whose length must be above 0, as must [param radius].
static func with_segment(
	position: ExactVector, velocity: ExactVector, radius: float, segment: LineSegment
) -> ExactImpact:
	var normal_now := _normal_if_touching(position, velocity, radius, segment)
	if normal_now:
		return _at_once(velocity, normal_now)
	var flat := _with_line(position, velocity, radius, segment)
	if flat.hit:
		return flat
	var start := _with_cap(position, velocity, radius, segment.start)
	var end := _with_cap(position, velocity, radius, segment.end)
	var is_start := start.hit and not (end.hit and end.time.is_less_than(start.time))
	return start if is_start else end


# The vector from the nearest point of the segment to the centre; null if that is longer than the
# radius.
static func _normal_if_touching(
	position: ExactVector, velocity: ExactVector, radius: float, segment: LineSegment
) -> ExactVector:
	var along := ExactVector.between(segment.start, segment.end)
	var difference := position.minus(ExactVector.from_vec2(segment.start))
	var share := difference.dot(along)
	var radius_squared := DoubleDouble.product_of(radius, radius)
	if share.high >= 0.0 and not along.dot(along).is_less_than(share):
		# The distance is d / |along|. Comparing the squares needs no root.
		var facing := _facing_normal(along, difference, velocity)
		var distance := difference.dot(facing)
		var reach := radius_squared.times(along.dot(along))
		return null if reach.is_less_than(distance.times(distance)) else facing
	if share.high > 0.0:
		difference = position.minus(ExactVector.from_vec2(segment.end))
	return null if radius_squared.is_less_than(difference.dot(difference)) else difference


static func _with_line(
	position: ExactVector, velocity: ExactVector, radius: float, segment: LineSegment
) -> ExactImpact:
	var along := ExactVector.between(segment.start, segment.end)
	var difference := position.minus(ExactVector.from_vec2(segment.start))
	var facing := _facing_normal(along, difference, velocity)
	# The way to the contact and the speed of approach, both times the length of the segment.
	var length := along.dot(along).square_root()
	var way := difference.dot(facing).minus(length.times(DoubleDouble.from_float(radius)))
	var approach := velocity.dot(facing).negated()
	if approach.high <= 0.0 or way.high < 0.0:
		return ExactImpact.new()
	var at := way.divided(approach)
	var share := difference.plus(velocity.scaled(at)).dot(along)
	if share.high < 0.0 or along.dot(along).is_less_than(share):
		return ExactImpact.new()
	return _impact(at, facing)


# |d + t v| = r has the smaller root t = c / (-b + root of D), in which no digits cancel, with
# b = d . v and c = d . d - r^2. D = b^2 - v^2 c is (r |v|)^2 - (d x v)^2. As a product of two
# factors it keeps the digits that the difference of squares loses for a small radius far away.
static func _with_cap(
	position: ExactVector, velocity: ExactVector, radius: float, cap: Vec2
) -> ExactImpact:
	var difference := position.minus(ExactVector.from_vec2(cap))
	var b := difference.dot(velocity)
	var c := difference.dot(difference).minus(DoubleDouble.product_of(radius, radius))
	if b.high >= 0.0 or c.high < 0.0:
		return ExactImpact.new()
	var reach := velocity.dot(velocity).square_root().times(DoubleDouble.from_float(radius))
	var offset := difference.turned().dot(velocity)
	var discriminant := reach.minus(offset).times(reach.plus(offset))
	if discriminant.high <= 0.0:
		return ExactImpact.new()
	var at := c.divided(discriminant.square_root().minus(b))
	return _impact(at, difference.plus(velocity.scaled(at)))


static func _at_once(velocity: ExactVector, with_normal: ExactVector) -> ExactImpact:
	if velocity.dot(with_normal).high >= 0.0:
		return ExactImpact.new()
	return _impact(DoubleDouble.from_float(0.0), with_normal)


# The normal on the side on which the ball is, as long as the segment. For a centre on the line
# itself it is on the side from which the ball comes.
static func _facing_normal(
	along: ExactVector, difference: ExactVector, velocity: ExactVector
) -> ExactVector:
	var right := along.turned()
	var side := difference.dot(right).high
	var is_left := side < 0.0 or (side == 0.0 and velocity.dot(right).high > 0.0)
	return ExactVector.new(right.x.negated(), right.y.negated()) if is_left else right


static func _impact(at: DoubleDouble, with_normal: ExactVector) -> ExactImpact:
	var impact := ExactImpact.new()
	impact.hit = true
	impact.time = at
	impact.normal = with_normal
	return impact
