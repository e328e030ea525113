class_name TimedQuestions
extends RefCounted
## What is asked of the ways to find the moment to fire.

## A fixed barrel, a target on a line.
const LINE := "target on a line"
## The same; both ways are within 1e-5 rad of each other.
const PARALLEL := "nearly parallel ways"
## A fixed barrel, a target on a circle.
const CIRCLE := "target on a circle"
## A barrel that turns all the time, a target on a line.
const TURNING := "turning barrel"
## All of them.
const SITUATIONS: PackedStringArray = [LINE, PARALLEL, CIRCLE, TURNING]

const _COUNT := 20
const _QUICK_COUNT := 5
const _SEED := 24
# Seconds. Looking frame by frame takes long until a later moment.
const _LATEST := 15.0


## Questions with an answer, the same at every call; the quick form has the first of them.
static func of(situation: String, is_quick: bool) -> Array[TimedQuestion]:
	var rng := RandomNumberGenerator.new()
	rng.seed = _SEED
	var found: Array[TimedQuestion] = []
	while found.size() < (_QUICK_COUNT if is_quick else _COUNT):
		var question := _question(situation, rng)
		question.solve()
		if question.careful.hit and question.careful.fire < _LATEST:
			found.append(question)
	return found


static func _question(situation: String, rng: RandomNumberGenerator) -> TimedQuestion:
	var question := TimedQuestion.new()
	question.muzzle = RandomPlace.among(rng)
	question.angle = rng.randf_range(-PI, PI)
	question.speed = rng.randf_range(200.0, 500.0)
	var velocity := Vec2.random_unit(rng).scaled(rng.randf_range(40.0, 150.0))
	question.target = AimTarget.new(RandomPlace.among(rng), velocity)
	match situation:
		PARALLEL:
			_make_parallel(question, rng)
		CIRCLE:
			question.target = AimTarget.new(question.target.position)
			question.circle_radius = rng.randf_range(60.0, 200.0)
			question.phase = rng.randf_range(-PI, PI)
			question.circle_turn = rng.randf_range(0.3, 2.0)
		TURNING:
			question.turn = rng.randf_range(0.2, 1.5)
	return question


# A target far ahead or behind that drives beside the bullet's way, by a hair's breadth.
static func _make_parallel(question: TimedQuestion, rng: RandomNumberGenerator) -> void:
	var along := Vec2.unit_radians(question.angle)
	var lean := rng.randf_range(1e-6, 1e-5)
	var velocity := Vec2.unit_radians(question.angle + lean).scaled(rng.randf_range(40.0, 150.0))
	var place := question.muzzle.plus(along.scaled(rng.randf_range(-400.0, 100.0)))
	place.subtract(along.normal().scaled(lean * rng.randf_range(200.0, 600.0)))
	question.target = AimTarget.new(place, velocity)
