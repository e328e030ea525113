class_name Crowd
extends RefCounted
## Many equal elastic balls in a square box without gravity. They cover a tenth of its area.

## The radius of each ball, in pixels.
const RADIUS := 10.0
## The fraction of the area that the balls cover.
const COVERED := 0.1
## The lowest speed at the start, in pixels per second.
const SLOWEST := 100.0
## The highest speed at the start, in pixels per second.
const FASTEST := 300.0

## The number of balls.
var count: int
## The simulated time, in seconds.
var seconds: float
## The box reaches from 0 to here, in x and y, in pixels.
var side: float


## A crowd of this many balls, simulated for this time.
func _init(of_count: int, for_seconds: float) -> void:
	count = of_count
	seconds = for_seconds
	side = sqrt(count * PI * RADIUS * RADIUS / COVERED)


## The balls at their start, the same at every call: each in a square of its own.
func balls() -> Array[Ball]:
	var rng := RandomNumberGenerator.new()
	rng.seed = count
	var squares := ceili(sqrt(count))
	var square := side / squares
	var play := square / 2.0 - RADIUS
	var found: Array[Ball] = []
	for i in count:
		var x := square * (i % squares + 0.5) + rng.randf_range(-play, play)
		var y := square * (floorf(float(i) / squares) + 0.5) + rng.randf_range(-play, play)
		var speed := rng.randf_range(SLOWEST, FASTEST)
		var velocity := Vec2.unit_radians(rng.randf() * TAU).scaled(speed)
		found.append(Ball.new(Vec2.new(x, y), RADIUS, velocity))
	return found


## The walls of the box.
func walls() -> Array[LineSegment]:
	var corners: Array[Vec2] = [
		Vec2.new(), Vec2.new(side, 0.0), Vec2.new(side, side), Vec2.new(0.0, side)
	]
	var found: Array[LineSegment] = []
	for i in corners.size():
		found.append(LineSegment.new(corners[i], corners[(i + 1) % corners.size()]))
	return found


## The deepest overlap of two balls in pixels: r1 + r2 less their distance; 0 if none overlap.
## [param places] holds x, y of each ball. They are sorted by x, so that each ball is compared with
## its neighbours only.
static func worst_overlap(places: PackedFloat64Array) -> float:
	var order: Array[int] = []
	order.assign(range(0, places.size(), 2))
	order.sort_custom(func(one: int, other: int) -> bool: return places[one] < places[other])
	var least := 4.0 * RADIUS * RADIUS
	for first in order.size():
		var one := order[first]
		for second in range(first + 1, order.size()):
			var other := order[second]
			var across := places[other] - places[one]
			if across * across >= least:
				break
			var down := places[other + 1] - places[one + 1]
			least = minf(least, across * across + down * down)
	return 2.0 * RADIUS - sqrt(least)


## The largest distance between the places of the same ball in both lists.
static func worst_distance(one: PackedFloat64Array, other: PackedFloat64Array) -> float:
	var worst := 0.0
	for i in range(0, one.size(), 2):
		var across := one[i] - other[i]
		var down := one[i + 1] - other[i + 1]
		worst = maxf(worst, across * across + down * down)
	return sqrt(worst)


## The change of the energy, as a fraction of the energy before. Both lists hold x, y of the
## velocity of each ball.
static func energy_drift(before: PackedFloat64Array, after: PackedFloat64Array) -> float:
	return absf(_squares(after) / _squares(before) - 1.0)


static func _squares(values: PackedFloat64Array) -> float:
	var sum := 0.0
	for value in values:
		sum += value * value
	return sum
