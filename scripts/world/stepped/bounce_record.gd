class_name BounceRecord
extends RefCounted
## One bounce of a ball, for a lesson to show.

## The index of the ball in its world.
var ball_index := 0
## The ball's centre at the impact, in pixels.
var position: Vec2
## The contact normal, from the line towards the ball; length 1.
var normal: Vec2
## The velocity just before the bounce, in pixels per second.
var velocity_before: Vec2
## The velocity just after the bounce, in pixels per second.
var velocity_after: Vec2
## The fraction t of the motion that was made before the impact, 0..1.
var fraction := 0.0
