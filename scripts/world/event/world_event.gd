class_name WorldEvent
extends RefCounted
## One thing that happened to a ball in an [EventWorld].

## What a ball met, or did: it touched a segment, a wall or another ball, came to rest on what it
## bounced on, slid off the end of it, or does not slip on it any more: then it rolls, stands still,
## or begins to slip the other way; or it was crushed between two surfaces, of which one moves, and
## is as it was just before.
enum Kind { SEGMENT, WALL, BALL, REST, LEAVE, SLIP_ENDS, CRUSHED }

## When, in seconds of the world.
var time := 0.0
## Which ball.
var ball := -1
## What happened.
var kind := Kind.SEGMENT
## The index of the segment, of the wall (0 left, 1 right, 2 top, 3 bottom) or of the other ball; -1
## for rest in a pile.
var other := -1
## Where both touch, in pixels.
var point: Vec2
## From what is touched to the ball's centre; length 1.
var normal: Vec2
## The ball's velocity before, in pixels per second.
var velocity_before: Vec2
## The ball's velocity after.
var velocity_after: Vec2
## The ball's spin before, in radians per second.
var spin_before := 0.0
## The ball's spin after.
var spin_after := 0.0
