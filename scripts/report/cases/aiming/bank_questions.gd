class_name BankQuestions
extends RefCounted
## What is asked of the ways to shoot over walls.

## Off a floor that is long enough.
const ONE := "one wall"
## The same; each bounce halves the speed along the normal.
const LOSSY := "one wall, C = 0.5"
## Two bounces in a box with two walls in it.
const ROOM := "room with walls in the way"
## All of them.
const SITUATIONS: PackedStringArray = [ONE, LOSSY, ROOM]

const _COUNT := 4
const _QUICK_COUNT := 2
const _SEED := 23
# Pixels.
const _RADIUS := 10.0
const _HALF_WIDTH := 450.0
const _HALF_HEIGHT := 350.0


## Questions with an answer, the same at every call; the quick form has the first of them.
static func of(situation: String, is_quick: bool) -> Array[BankQuestion]:
	var rng := RandomNumberGenerator.new()
	rng.seed = _SEED
	var found: Array[BankQuestion] = []
	while found.size() < (_QUICK_COUNT if is_quick else _COUNT):
		var question := _question(situation, rng)
		if _has_room(question) and careful(question).hit:
			found.append(question)
	return found


## The answer of [method BankAim.first] to a question.
static func careful(question: BankQuestion) -> BankWay:
	return BankAim.first(
		question.start,
		question.target,
		question.radius,
		question.bounciness,
		question.walls,
		question.bounces
	)


static func _question(situation: String, rng: RandomNumberGenerator) -> BankQuestion:
	var question := BankQuestion.new()
	question.start = RandomPlace.among(rng)
	question.target = RandomPlace.among(rng)
	question.radius = _RADIUS
	question.bounciness = 0.5 if situation == LOSSY else 1.0
	question.bounces = 2 if situation == ROOM else 1
	question.walls = _room(rng) if situation == ROOM else _floor(rng)
	return question


# A floor that leans a little, below all places.
static func _floor(rng: RandomNumberGenerator) -> Array[LineSegment]:
	var left := Vec2.new(-2000.0, 450.0 + rng.randf_range(0.0, 300.0))
	return [LineSegment.new(left, Vec2.new(2000.0, 450.0 + rng.randf_range(0.0, 300.0)))]


static func _room(rng: RandomNumberGenerator) -> Array[LineSegment]:
	var corners: Array[Vec2] = [
		Vec2.new(-_HALF_WIDTH, -_HALF_HEIGHT),
		Vec2.new(_HALF_WIDTH, -_HALF_HEIGHT),
		Vec2.new(_HALF_WIDTH, _HALF_HEIGHT),
		Vec2.new(-_HALF_WIDTH, _HALF_HEIGHT)
	]
	var walls: Array[LineSegment] = []
	for place in corners.size():
		walls.append(LineSegment.new(corners[place - 1], corners[place]))
	for more in 2:
		var from := RandomPlace.among(rng)
		walls.append(LineSegment.new(from, from.plus(Vec2.random_unit(rng).scaled(300.0))))
	return walls


# Whether neither the start nor the target is in a wall.
static func _has_room(question: BankQuestion) -> bool:
	for wall in question.walls:
		for place: Vec2 in [question.start, question.target]:
			if wall.closest_point(place).distance_to(place) <= _RADIUS:
				return false
	return true
