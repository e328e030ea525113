@abstract class_name ShotKind
extends FuzzKind
## Random shots: what the aiming code answers is flown in the event world, and must hit; and a dense
## search must not find an earlier shot.
##
## Ball 0 is the bullet: where it starts, with its speed. Ball 1 is the target. A ball with the
## radius [constant POINT] is a point.
##
## A shot may miss by [constant MOST] times eps times its condition. The condition adds up how far
## the shot misses when its numbers are wrong, each by its own size. So a rounding on the way counts
## for half of eps times a part of it. An answer has two or three roundings in its direction and as
## many in its time, and the flight has about five. The largest of 150 000 misses was 0.94.

## See the class.
const MOST := 4.0
## Pixels.
const POINT := 1e-6

# A search looks at so many moments.
const _MOMENTS := 400
# Of the sizes that a sum is made of, what its rounding may make of a zero.
const _ROUNDING := 32.0 * ShotCondition.EPSILON

## How many questions were asked, and how many shots came of them.
var asked := 0
## See [member asked].
var flown := 0
## The largest miss, in eps times the condition.
var worst := 0.0


func figures() -> String:
	return (
		"%s: %d asked, %d shots flown, the largest miss is %.2f eps times its condition"
		% [name, asked, flown, worst]
	)


func problem_of(world: FuzzWorld) -> String:
	if not can_be_asked(world):
		return ""
	asked += 1
	return problem_of_shots(world)


## Whether there are a bullet and a target in this world, and whether it may be asked for a shot.
func can_be_asked(world: FuzzWorld) -> bool:
	return world.balls.size() >= 2 and world.balls[0].velocity.length() > 0.0


## "" or one sentence on what is wrong with the shots of this world.
@abstract func problem_of_shots(world: FuzzWorld) -> String


## "" or a sentence on a shot that missed by [param missed], in pixels, when it was flown.
## [param miss] tells the same for other [param numbers].
func problem_of_flight(missed: Vec2, numbers: PackedFloat64Array, miss: Callable) -> String:
	var condition := ShotCondition.of(numbers, miss)
	var ratio := missed.length() / (ShotCondition.EPSILON * condition)
	if missed.length() == 0.0:
		ratio = 0.0
	flown += 1
	worst = maxf(worst, ratio)
	if ratio <= MOST:
		return ""
	return (
		"A shot misses by %s px, which is %s eps times its condition."
		% [DecimalText.of(missed.length()), DecimalText.of(ratio)]
	)


## The radius of a ball, 0 for a point.
static func radius_of(ball: Ball) -> float:
	return ball.radius if ball.radius > POINT else 0.0


## A place in a field of 800 x 600 px; some have whole numbers, so that things are in line.
static func place(rng: RandomNumberGenerator) -> Vec2:
	var at := Vec2.new(rng.randf_range(-400.0, 400.0), rng.randf_range(-300.0, 300.0))
	return Vec2.new(snappedf(at.x, 50.0), snappedf(at.y, 50.0)) if rng.randf() < 0.15 else at


## A vector with a length between these two; some are along an axis.
static func vector(rng: RandomNumberGenerator, shortest: float, longest: float) -> Vec2:
	var along := Vec2.random_unit(rng)
	if rng.randf() < 0.15:
		along = Vec2.unit_degrees(90.0 * rng.randi_range(0, 3))
	return along.scaled(rng.randf_range(shortest, longest))


## Moves all of a world far away from the origin.
static func move_far(world: FuzzWorld, rng: RandomNumberGenerator) -> void:
	var far := Vec2.random_unit(rng).scaled(10.0 ** rng.randf_range(4.0, 7.0))
	for ball: Ball in world.balls:
		ball.position.add(far)
	for line: LineSegment in world.lines:
		line.start.add(far)
		line.end.add(far)


## Moments after 0 until [param last], evenly spread.
static func moments(last: float) -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	for number: int in range(1, _MOMENTS + 1):
		found.append(last * number / _MOMENTS)
	return found


## What rounding may make of a sum of numbers of these sizes where it is zero.
static func rounding(sizes: PackedFloat64Array) -> float:
	var sum := 0.0
	for size: float in sizes:
		sum += absf(size)
	return _ROUNDING * sum


## A zero of [param function] between two moments at which its signs differ.
static func zero_between(function: Callable, low: float, high: float) -> float:
	var at_low: float = function.call(low)
	for halving: int in 60:
		var middle := 0.5 * (low + high)
		var at_middle: float = function.call(middle)
		if (at_middle < 0.0) == (at_low < 0.0):
			low = middle
		else:
			high = middle
	return 0.5 * (low + high)


## The zeros of [param function] that a search at these moments finds; the first is after 0.
static func zeros(function: Callable, at: PackedFloat64Array) -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	var before := 0.0
	var value_before: float = function.call(0.0)
	for moment: float in at:
		var value: float = function.call(moment)
		if (value < 0.0) != (value_before < 0.0):
			found.append(zero_between(function, before, moment))
		before = moment
		value_before = value
	return found
