class_name BankShotAnswer
extends RefCounted
## What a board of the lesson on bank shots leads to: the ways over the walls, the one that is
## shown, and how the shots fly. Computed once for each state.

## The right shot arrives after so many seconds.
const SECONDS := 2.0
## All shots are followed for so many seconds.
const LONGEST := 3.0

## For each order of walls the way that gets farthest: a hit where there is one. An order without
## images is none: start and target are on different sides of its only wall.
var ways: Array[BankWay] = []
## The way that is shown: the one that was picked, else the first to arrive, else the one that gets
## farthest.
var way: BankWay
## The speed of all shots, in px/s.
var speed := 0.0
## The wall, by its place, that start or target overlaps; -1 for none. Then nothing is shot.
var overlapped := -1
## The places of the right shot: start, bounces, and where it has arrived; empty without a hit.
var corners: Array[Vec2] = []
## The direction of the mistake that is switched on; zero where there is none.
var wrong_direction := Vec2.new()
## The places of the shot of the mistake; empty where there is none.
var wrong_corners: Array[Vec2] = []

## How far rounding alone may move the right shot, in pixels: [constant ShotCondition.EPSILON] times
## its condition; NAN until [method measure_bound].
var bound := NAN

var _board: BankBoard
var _right_shot: FiredShot
var _wrong_shot: FiredShot


## Of [param board], with the [param order] of walls that was picked, "" for none, and the number of
## the [param mistake] that is switched on, 0 for none.
func _init(board: BankBoard, order: String, mistake: int) -> void:
	_board = board.copy()
	overlapped = _board.overlapped_wall()
	_find_ways()
	_pick_way(order)
	speed = way.distance / SECONDS if way.images else 0.0
	if way.hit:
		corners = shot(way.direction).corners(SECONDS)
	if mistake != 0 and way.images and overlapped < 0:
		wrong_direction = BankShotMistakes.direction(mistake, _board, way)
		wrong_corners = shot(wrong_direction).corners(LONGEST)


## A shot in [param direction], as it flies in the event world.
func shot(direction: Vec2) -> FiredShot:
	return FiredShot.new(
		_board.start,
		direction.scaled(speed),
		Vec2.zero(),
		_board.radius,
		_board.walls,
		_board.bounciness
	)


## Where the right ball is so many [param seconds] after the shot, in pixels.
func right_place_after(seconds: float) -> Vec2:
	if _right_shot == null:
		_right_shot = shot(way.direction)
	return _right_shot.place_after(seconds)


## The same for the ball of the mistake.
func wrong_place_after(seconds: float) -> Vec2:
	if _wrong_shot == null:
		_wrong_shot = shot(wrong_direction)
	return _wrong_shot.place_after(seconds)


## By how much the right shot misses, in pixels: the smallest distance of ball and target.
func miss() -> float:
	return distance_of(corners)


## Finds [member bound]. Some 40 shots are flown for it: too many for each moment of a drag.
func measure_bound() -> void:
	if is_nan(bound) and way.hit:
		bound = ShotCondition.EPSILON * ShotCondition.of(_numbers(), _miss_of)


## By how much the shot of the mistake misses, in pixels.
func wrong_miss() -> float:
	return distance_of(wrong_corners)


## Whether the mistake that is switched on leads to another direction.
func mistake_shows() -> bool:
	return not wrong_corners.is_empty() and wrong_direction.distance_to(way.direction) > 1e-9


## The smallest distance between the target and a way through [param places], in pixels.
func distance_of(places: Array[Vec2]) -> float:
	var least := INF
	for at in range(1, places.size()):
		var leg := LineSegment.new(places[at - 1], places[at])
		least = minf(least, leg.closest_point(_board.target).distance_to(_board.target))
	return least


## The wall, by its place, at which [param refused], which is no hit, fails: the one that it does
## not come to or bounces beside; -1 where something is in its way.
static func failing_wall(refused: BankWay) -> int:
	match refused.outcome:
		BankWay.Outcome.NONE:
			return refused.walls[0]
		BankWay.Outcome.BEHIND, BankWay.Outcome.NOT_REACHED:
			return refused.walls[refused.bounces.size()]
		BankWay.Outcome.BESIDE:
			return refused.walls[refused.bounces.size() - 1]
	return -1


# An order may have several ways, on different sides of a wall.
func _find_ways() -> void:
	var best: Dictionary[String, BankWay] = {}
	for order in _board.orders():
		best[order] = BankWay.new()
		best[order].walls = BankBoard.walls_of(order)
	for one in _board.ways():
		var order := BankBoard.order_of(one.walls)
		if _rank(one) > _rank(best[order]):
			best[order] = one
	ways = best.values()


func _pick_way(order: String) -> void:
	way = ways[0]
	for one in ways:
		if order:
			way = one if BankBoard.order_of(one.walls) == order else way
		elif _rank(one) > _rank(way) or one.hit and one.distance < way.distance:
			way = one


# The farther a way gets, the larger; a hit is above all.
static func _rank(one: BankWay) -> int:
	return BankWay.Outcome.size() if one.hit else one.outcome


# All that the right shot hangs on.
func _numbers() -> PackedFloat64Array:
	var numbers: PackedFloat64Array = [
		_board.start.x,
		_board.start.y,
		_board.target.x,
		_board.target.y,
		_board.radius,
		_board.bounciness,
		way.direction.x,
		way.direction.y,
		way.distance,
	]
	for wall in _board.walls:
		numbers.append_array([wall.start.x, wall.start.y, wall.end.x, wall.end.y])
	return numbers


# Where the ball is from the target when it should have arrived. No ball bounces with a C above 1:
# there the miss goes on as straight as it comes.
static func _miss_of(numbers: PackedFloat64Array) -> Vec2:
	if numbers[5] <= 1.0:
		return _flown_miss(numbers, numbers[5])
	return _flown_miss(numbers, 1.0).scaled(2.0).minus(_flown_miss(numbers, 2.0 - numbers[5]))


# With a speed of 1, time is distance.
static func _flown_miss(numbers: PackedFloat64Array, bounciness: float) -> Vec2:
	var walls: Array[LineSegment] = []
	for at in range(9, numbers.size(), 4):
		var start := Vec2.new(numbers[at], numbers[at + 1])
		walls.append(LineSegment.new(start, Vec2.new(numbers[at + 2], numbers[at + 3])))
	var fired := FiredShot.new(
		Vec2.new(numbers[0], numbers[1]),
		Vec2.new(numbers[6], numbers[7]),
		Vec2.zero(),
		numbers[4],
		walls,
		bounciness
	)
	return fired.place_after(numbers[8]).minus(Vec2.new(numbers[2], numbers[3]))
