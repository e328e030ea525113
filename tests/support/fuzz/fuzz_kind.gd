@abstract class_name FuzzKind
extends RefCounted
## A kind of random worlds, and what must hold in every world of this kind.

## More impacts than this in one world are a case for patience, and not for a judge.
const MOST_IMPACTS := 20_000

## What it is called.
var name := ""
## How the lesson on angled lines shows a world of this kind.
var method := SteppingMethods.Method.EVENT_WORLD

## The world with this number; the same for the same number.
@abstract func world_of(number: int) -> FuzzWorld

## "" or one sentence on what does not hold in a world of this kind. It may be any such world, as
## the shrinker makes them. It changes nothing in it.
@abstract func problem_of(world: FuzzWorld) -> String


## One line on all worlds that were judged so far; "" for none.
func figures() -> String:
	return ""


## A problem without its numbers: two worlds with the same sort show, as a rule, one mistake.
static func sort_of(problem: String) -> String:
	return RegEx.create_from_string("-?(inf|nan|\\d[\\d.]*(e[+-]?\\d+)?)").sub(problem, "#", true)


## A generator of random numbers for the world with this number.
static func random(number: int) -> RandomNumberGenerator:
	var rng := RandomNumberGenerator.new()
	rng.seed = number
	return rng


## Gives some worlds friction, and their balls spin. To be called last: what is drawn before stays
## the same.
static func rub(made: FuzzWorld, rng: RandomNumberGenerator) -> void:
	if rng.randf() < 0.6:
		return
	made.friction = [0.1, 0.5, 1.0, rng.randf_range(0.0, 2.0)][rng.randi() % 4]
	for ball: Ball in made.balls:
		ball.spin = rng.randf_range(-30.0, 30.0) if rng.randf() < 0.5 else 0.0


## All balls of an event world as they are now.
static func balls_of(world: WatchedWorld) -> Array[Ball]:
	var found: Array[Ball] = []
	for index: int in world.ball_places():
		found.append(world.ball(index))
	return found


## Whether a ball is inside a line or wall at the start: what becomes of it is another question.
## [param built] is the event world of this world.
static func starts_inside(world: FuzzWorld, built: WatchedWorld) -> bool:
	for ball: Ball in world.balls:
		if InsideCheck.problem(ball, built.nearest_points(ball)):
			return true
	return false
