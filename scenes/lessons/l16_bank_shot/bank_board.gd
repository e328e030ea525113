class_name BankBoard
extends RefCounted
## The task of the lesson on bank shots: a ball, its target, and walls between which it bounces.
## Lengths are in pixels.

## The walls; their numbers on screen begin with 1.
var walls: Array[LineSegment] = []
## The ball's centre at the start, and where it has to come to.
var start := Vec2.new(100.0, 100.0)
var target := Vec2.new(300.0, 160.0)
## The ball's radius.
var radius := 20.0
## The bounciness C.
var bounciness := 1.0
## How many bounces there have to be.
var bounces := 1


## A board that shares nothing with this one.
func copy() -> BankBoard:
	var board := BankBoard.new()
	for wall in walls:
		board.walls.append(wall.copy())
	board.start = start.copy()
	board.target = target.copy()
	board.radius = radius
	board.bounciness = bounciness
	board.bounces = bounces
	return board


## All orders of walls for so many bounces: their numbers on screen, such as `12`. No wall comes
## twice in a row.
func orders() -> PackedStringArray:
	var found: PackedStringArray = [""]
	for bounce in bounces:
		var longer: PackedStringArray = []
		for shorter in found:
			for wall in walls.size():
				if not shorter.ends_with(str(wall + 1)):
					longer.append(shorter + str(wall + 1))
		found = longer
	return found


## [param places] of walls, counted from 0, as an order.
static func order_of(places: PackedInt32Array) -> String:
	var found := ""
	for place in places:
		found += str(place + 1)
	return found


## The places of the walls of [param order], counted from 0.
static func walls_of(order: String) -> PackedInt32Array:
	var found: PackedInt32Array = []
	for number in order:
		found.append(number.to_int() - 1)
	return found


## Start, target and the ends of all walls.
func points() -> Array[Vec2]:
	var found: Array[Vec2] = [start, target]
	for wall in walls:
		found.append(wall.start)
		found.append(wall.end)
	return found


## The wall, by its place, that the ball overlaps at the start or at the target; -1 for none.
func overlapped_wall() -> int:
	for place in walls.size():
		for point: Vec2 in [start, target]:
			if walls[place].closest_point(point).distance_to(point) <= radius:
				return place
	return -1


## What [method BankAim.first] answers.
func first_way() -> BankWay:
	return BankAim.first(start, target, radius, bounciness, walls, bounces)


## What [method BankAim.ways] answers.
func ways() -> Array[BankWay]:
	return BankAim.ways(start, target, radius, bounciness, walls, bounces)


## How far the direction of [param way] is from the exact one.
func error_of(way: BankWay) -> float:
	var used: Array[LineSegment] = []
	for place in way.walls:
		used.append(walls[place])
	return ExactBank.error_of_direction(
		way.direction, start, target, radius, bounciness, used, way.sides
	)
