class_name Impact
extends RefCounted
## What became of the search for an impact. Without a [member hit], only [member outcome] means
## something.

## Why there is an impact or none.
enum Outcome { HIT, TOO_FAR, MOVING_AWAY, PARALLEL, PASSES_BESIDE }

## What was touched: the line between its ends, or one of the round caps.
enum Feature { LINE, START, END }

## The ball touches within this frame.
var hit := false
## How much of the frame's motion has been made when it touches, 0..1.
var time := 0.0
## The ball's centre at that moment, in pixels: the point of impact.
var position: Vec2
## From what is touched to the ball's centre; length 1.
var normal: Vec2
## What is touched.
var feature := Feature.LINE
## Which of several segments is touched, by its place in the list; -1 where there was only one.
var segment_index := -1
## Why there is an impact or none.
var outcome := Outcome.TOO_FAR


## No impact, for the reason [param reason].
static func miss(reason: Outcome) -> Impact:
	var impact := Impact.new()
	impact.outcome = reason
	return impact


## An impact after the share [param at_time] of the frame, with the ball's centre at
## [param at_position] and the contact normal [param with_normal].
static func at(at_time: float, at_position: Vec2, with_normal: Vec2, of: Feature) -> Impact:
	var impact := Impact.new()
	impact.hit = true
	impact.outcome = Outcome.HIT
	impact.time = at_time
	impact.position = at_position
	impact.normal = with_normal
	impact.feature = of
	return impact
