class_name GrazingEntry
extends RefCounted
## The time at which a ball enters a circle that its path nearly grazes: so nearly that rounding
## hides whether the path enters the circle at all, or leaves it before it enters again. The quartic
## |d + v t + g t² / 2|² - r² is expanded about its turning point, with the values that
## [ExactParabola] gives there.
##
## Slow, and needed only in one flight out of many millions.

## [ExactParabola] cannot tell a height from 0 below this times the sizes of its terms. A path that
## grazes more closely than that counts as staying on its side.
const _EXACT_NOISE := 1.0 / 2.0 ** 98


## The time in seconds of the entry next to the turning point of the quartic that is close to
## [param near]: before a minimum, after a maximum. INF if the ball stays on the same side. The
## flight starts at (px, py) with the velocity (vx, vy) and the acceleration (gx, gy), in pixels and
## seconds; the circle has the centre (cx, cy).
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
	var turning := near
	var x := 0.0
	var y := 0.0
	var ux := 0.0
	var uy := 0.0
	var bend := 0.0
	for _count in 3:
		x = dx + turning * (vx + 0.5 * turning * gx)
		y = dy + turning * (vy + 0.5 * turning * gy)
		ux = vx + turning * gx
		uy = vy + turning * gy
		bend = ux * ux + uy * uy + x * gx + y * gy
		turning -= (x * ux + y * uy) / bend
	var exact := ExactParabola.new(px, py, vx, vy, gx, gy)
	var growth := exact.growth(cx, cy, turning)
	var height := exact.squared_gap(cx, cy, radius, turning)
	var to_vertex := -growth / bend
	var squared := to_vertex * to_vertex - height / bend
	var terms_x := absf(dx) + turning * (absf(vx) + turning * absf(gx))
	var terms_y := absf(dy) + turning * (absf(vy) + turning * absf(gy))
	if not squared * absf(bend) > _EXACT_NOISE * radius * (radius + terms_x + terms_y):
		return INF
	var third := ux * gx + uy * gy
	var fourth := 0.25 * (gx * gx + gy * gy)
	var offset := to_vertex - signf(bend) * sqrt(squared)
	# The terms of third and fourth order are small here, but not always smaller than rounding.
	for _count in 2:
		var value := offset * (2.0 * growth + offset * (bend + offset * (third + offset * fourth)))
		var slope := offset * (2.0 * bend + offset * (3.0 * third + offset * 4.0 * fourth))
		offset -= (value + height) / (slope + 2.0 * growth)
	return turning + offset
