class_name GrazingEntry
extends RefCounted
## When a ball enters a circle that its path nearly grazes, so nearly that rounding hides whether it
## gets in at all: from the lowest point of the quartic |d + v t + g t² / 2|² - r², written out anew
## about that point with [ExactParabola].
##
## Slow, and needed only in one flight of many millions.


## The time of the entry just before the lowest point of the quartic, which must lie close to
## [param near] (seconds); INF if the ball stays outside. The flight starts at (px, py) with the
## velocity (vx, vy) and the acceleration (gx, gy), in pixels and seconds; the circle has the centre
## (cx, cy). The path must be bent away from the circle there.
static func time(
	px: float,
	py: float,
	vx: float,
	vy: float,
	gx: float,
	gy: float,
	radius: float,
	cx: float,
	cy: float,
	near: float
) -> float:
	var dx := px - cx
	var dy := py - cy
	var lowest := near
	var x := 0.0
	var y := 0.0
	var ux := 0.0
	var uy := 0.0
	var bend := 0.0
	for _count in 3:
		x = dx + lowest * (vx + 0.5 * lowest * gx)
		y = dy + lowest * (vy + 0.5 * lowest * gy)
		ux = vx + lowest * gx
		uy = vy + lowest * gy
		bend = ux * ux + uy * uy + x * gx + y * gy
		lowest -= (x * ux + y * uy) / bend
	var exact := ExactParabola.new(px, py, vx, vy, gx, gy)
	var growth := exact.growth(cx, cy, lowest)
	var height := exact.squared_gap(cx, cy, radius, lowest)
	var depth := growth * growth / bend - height
	if not depth > 0.0:
		return INF
	var third := ux * gx + uy * gy
	var fourth := 0.25 * (gx * gx + gy * gy)
	var offset := -growth / bend - sqrt(depth / bend)
	# The terms of third and fourth order are small there, but not always below rounding.
	for _count in 2:
		var value := offset * (2.0 * growth + offset * (bend + offset * (third + offset * fourth)))
		var slope := offset * (2.0 * bend + offset * (3.0 * third + offset * 4.0 * fourth))
		offset -= (value + height) / (slope + 2.0 * growth)
	return lowest + offset
