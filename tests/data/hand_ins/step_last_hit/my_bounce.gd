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
	var left := seconds
	for turn in 20:
		var motion := ball.velocity.scaled(left).plus(ball.acceleration.scaled(left * left / 2.0))
		var first := 2.0
		var hit: MyVec2 = null
		for line in lines:
			var normal: MyVec2 = line.end.minus(line.start).normal()
			var old: float = ball.position.minus(line.start).dot(normal)
			if old < 0.0:
				normal = normal.scaled(-1.0)
				old = -old
			var approach := -motion.dot(normal)
			if approach > 0.0:
				var t: float = maxf((old - ball.radius) / approach, 0.0)
				if t <= 1.0:
					first = t
					hit = normal
		if hit == null:
			ball.position = ball.position.plus(motion)
			ball.velocity = ball.velocity.plus(ball.acceleration.scaled(left))
			return
		ball.position = ball.position.plus(motion.scaled(first))
		ball.velocity = ball.velocity.plus(ball.acceleration.scaled(left * first))
		ball.velocity.reflect(hit)
		left *= 1.0 - first
