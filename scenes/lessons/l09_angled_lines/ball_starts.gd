class_name BallStarts
extends RefCounted
## The place and velocity of each ball at the start: a lost ball is brought back there.

var _balls: Array[Ball] = []


## Takes the balls of [param world] as they are now.
func take(world: SteppedWorld) -> void:
	_balls.clear()
	for ball in world.balls:
		_balls.append(ball.copy())


## Another start for one ball.
func change(index: int, ball: Ball) -> void:
	_balls[index] = ball.copy()


## Brings every lost ball of [param world] back to its start.
func fetch(world: SteppedWorld) -> void:
	for i in world.balls.size():
		if world.is_lost[i]:
			world.bring_back(i, _balls[i])


## The place and velocity of each, for undo and links.
func numbers() -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	for ball in _balls:
		found.append_array([ball.position.x, ball.position.y, ball.velocity.x, ball.velocity.y])
	return found


## Puts back what [method numbers] returned.
func put(numbers_told: PackedFloat64Array) -> void:
	for i in _balls.size():
		_balls[i].position.set_xy(numbers_told[4 * i], numbers_told[4 * i + 1])
		_balls[i].velocity.set_xy(numbers_told[4 * i + 2], numbers_told[4 * i + 3])
