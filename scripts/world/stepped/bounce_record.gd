class_name BounceRecord
extends RefCounted
## One bounce as it happened: what a lesson shows of it.

## Which ball, by its place among all.
var ball_index := 0
## The ball's centre at the impact, in pixels.
var position: Vec2
## From the line to the ball; length 1.
var normal: Vec2
## Pixels per second, just before the bounce.
var velocity_before: Vec2
## Pixels per second, just after it.
var velocity_after: Vec2
## The share t of the motion that was made before the impact, 0..1.
var time := 0.0
