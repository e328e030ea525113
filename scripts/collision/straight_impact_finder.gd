class_name StraightImpactFinder
extends RefCounted
## The exact impact of a ball in straight flight with a point, or with a segment that has two sides
## and round caps at its ends. Times are in seconds from now; there is no frame.
##
## The impact is the first time at which the ball touches while it approaches, that is, while its
## velocity has a part against the contact normal. A ball that touches or overlaps already has its
## impact at time 0 if it approaches, and none if it moves away or along.
## [br][br]
## The steps are those of [PointOfImpact] and [CapImpact], in plain numbers and in a form that loses
## no digits: divisions by a length come last, and |d x v| replaces the difference of squares under
## the root. To search many segments, make one finder and call it for each: nothing is allocated.
## After a call that returned false, the members have no meaning.

## Seconds until the impact; 0 where the ball touches already.
var time := 0.0
## x of the contact normal: length 1, towards the ball.
var normal_x := 0.0
## y of the contact normal.
var normal_y := 0.0
## Which part of a segment is touched.
var feature := Impact.Feature.LINE


## Whether a ball with its centre at (px, py) and the velocity (vx, vy) meets the point (cx, cy):
## its centre comes within [param radius] of the point. For the impact of two balls, give the
## position and velocity of one less those of the other, the sum of both radii, and the point (0,
## 0).
func with_point(
	px: float, py: float, vx: float, vy: float, radius: float, cx: float, cy: float
) -> bool:
	var dx := px - cx
	var dy := py - cy
	var approach := -(dx * vx + dy * vy)
	if not approach > 0.0:
		return false
	var distance := sqrt(dx * dx + dy * dy)
	if distance <= radius:
		return _touches_at(0.0, dx, dy)
	# r² - distance² at the nearest point of the path, times v.v.
	var reach := radius * sqrt(vx * vx + vy * vy)
	var offset := absf(dx * vy - dy * vx)
	var discriminant := (reach - offset) * (reach + offset)
	# Below 0 the ball stays farther away than its radius. At 0 it only grazes the point.
	if not discriminant > 0.0:
		return false
	var seconds := (distance - radius) * (distance + radius) / (approach + sqrt(discriminant))
	return _touches_at(seconds, dx + vx * seconds, dy + vy * seconds)


## Whether a ball with its centre at (px, py) and the velocity (vx, vy) meets the segment from
## (ax, ay) to (bx, by), whose length must not be 0.
func with_segment(
	px: float,
	py: float,
	vx: float,
	vy: float,
	radius: float,
	ax: float,
	ay: float,
	bx: float,
	by: float
) -> bool:
	var ex := bx - ax
	var ey := by - ay
	var dx := px - ax
	var dy := py - ay
	var squared := ex * ex + ey * ey
	var length := sqrt(squared)
	# The distance from the line and how fast it shrinks, both times the length of the segment.
	var distance := ex * dy - ey * dx
	var approach := ey * vx - ex * vy
	var side := 1.0
	if distance < 0.0 or (distance == 0.0 and approach < 0.0):
		side = -1.0
		distance = -distance
		approach = -approach
	var along := ex * dx + ey * dy
	var gap := distance - radius * length
	if gap > 0.0:
		# Farther from the line than the radius: neither end can be touched before the line is.
		if not approach > 0.0:
			return false
		time = gap / approach
		along += (ex * vx + ey * vy) * time
	elif along >= 0.0 and along <= squared:
		# Between the ends and closer than the radius.
		if not approach > 0.0:
			return false
		time = 0.0
	# Closer to the line than the radius, the ball can meet only the end beyond which it is.
	if along < 0.0:
		feature = Impact.Feature.START
		return with_point(px, py, vx, vy, radius, ax, ay)
	if along > squared:
		feature = Impact.Feature.END
		return with_point(px, py, vx, vy, radius, bx, by)
	feature = Impact.Feature.LINE
	normal_x = -ey / length * side
	normal_y = ex / length * side
	return true


func _touches_at(seconds: float, dx: float, dy: float) -> bool:
	var distance := sqrt(dx * dx + dy * dy)
	time = seconds
	# A centre on the point itself has no side: the normal is (0, 0).
	normal_x = dx / distance if distance > 0.0 else 0.0
	normal_y = dy / distance if distance > 0.0 else 0.0
	return true
