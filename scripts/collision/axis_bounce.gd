class_name AxisBounce
extends RefCounted
## The easy case, parts 1 and 2 of the lecture: a horizontal floor or a vertical wall. One
## coordinate is tested and put back, and one component of the velocity is flipped. This is wrong
## for every other line.


## Whether the ball's lowest point is below the floor at [param floor_y]: y points down.
static func hits_floor(ball: Ball, floor_y: float) -> bool:
	return ball.position.y + ball.radius > floor_y


## Puts the ball back on the floor: straight up, no matter from where it came.
static func put_on_floor(ball: Ball, floor_y: float) -> void:
	ball.position.y = floor_y - ball.radius


## Bounces off the floor: the y of the velocity changes its sign and is multiplied by
## [param bounciness].
static func flip_y(ball: Ball, bounciness: float = 1.0) -> void:
	ball.velocity.y *= -bounciness


## Whether the ball reaches beyond the wall on its right at [param wall_x].
static func hits_wall(ball: Ball, wall_x: float) -> bool:
	return ball.position.x + ball.radius > wall_x


## Puts the ball back to the left of the wall.
static func put_beside_wall(ball: Ball, wall_x: float) -> void:
	ball.position.x = wall_x - ball.radius


## Bounces off the wall: the x of the velocity changes its sign and is multiplied by
## [param bounciness].
static func flip_x(ball: Ball, bounciness: float = 1.0) -> void:
	ball.velocity.x *= -bounciness
