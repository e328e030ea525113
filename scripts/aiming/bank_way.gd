class_name BankWay
extends RefCounted
## A way of a ball from wall to wall to a target, or why it is none. Read [member hit] first:
## without a hit, [member outcome] says what is wrong with it.

## Why it is a way, or why it is none: no way was found at all; the ball is not on the side from
## which it would bounce; it would not come to the wall; it would bounce beside an end; something
## is in the way.
enum Outcome { HIT, NONE, BEHIND, NOT_REACHED, BESIDE, BLOCKED }

## Whether the ball reaches the target.
var hit := false
## The direction in which the ball starts, length 1.
var direction: Vec2
## How far the ball would fly in the same time at the speed of the start, in pixels: without loss
## the length of the way.
var distance := INF
## The indices of the walls in the order of the bounces.
var walls: PackedInt32Array = []
## For each of these walls the side on which the ball bounces: 1 where the wall's normal points,
## else -1.
var sides: PackedFloat64Array = []
## For each bounce the centre of the ball, in pixels.
var bounces: Array[Vec2] = []
## The images of the target: at which the ball flies at the start and after each bounce; the last
## one is the target itself.
var images: Array[Vec2] = []
## Why it is a way, or why it is none.
var outcome := Outcome.NONE
