class_name MyBounce
extends RefCounted
## Your ball among many lines: assignment 4.


## A ball, as the lab hands it to [method MyBounce.step].
class MyBall:
	## The centre in pixels.
	var position: MyVec2
	## Pixels per second.
	var velocity: MyVec2
	## Pixels per second squared, such as gravity.
	var acceleration: MyVec2
	## Pixels.
	var radius := 10.0


## A line with two ends. Both of its sides count.
class MySegment:
	## The first point, in pixels.
	var start: MyVec2
	## The second point, in pixels.
	var end: MyVec2


## Exercise 10: move [param ball] for [param seconds], which is one frame. [param lines] holds
## MySegments. The ball bounces off each line that it meets, with bounciness 1. Change the ball's
## position and velocity; give nothing back.
static func step(ball: MyBall, lines: Array, seconds: float) -> void:
	ball.position = ball.position.plus(ball.velocity.scaled(seconds)).plus(ball.acceleration.scaled(seconds * seconds / 2.0))
	ball.velocity = ball.velocity.plus(ball.acceleration.scaled(seconds))
