class_name Impact
extends RefCounted
## The result of a search for an impact within one frame. Read [member hit] first: without a hit,
## only [member outcome] has a meaning.

## Why there is an impact, or why there is none.
enum Outcome { HIT, TOO_FAR, MOVING_AWAY, PARALLEL, PASSES_BESIDE }

## What was touched: the line between its ends, or one of the round caps.
enum Feature { LINE, START, END }

## Whether the ball touches within this frame.
var hit := false
## The fraction of the frame's motion that is made before the impact, 0..1.
var fraction := 0.0
## The ball's centre at that moment, in pixels: the point of impact.
var position: Vec2
## The contact normal, from what is touched towards the ball's centre; length 1.
var normal: Vec2
## What is touched.
var feature := Feature.LINE
## The index of the touched segment in the list that was searched; -1 where there was no list.
var segment_index := -1
## Why there is an impact, or why there is none.
var outcome := Outcome.TOO_FAR


## A result without a hit, for the reason [param reason].
static func miss(reason: Outcome) -> Impact:
	var impact := Impact.new()
	impact.outcome = reason
	return impact


## An impact after the fraction [param at_fraction] of the frame, with the ball's centre at
## [param at_position] and the contact normal [param with_normal].
static func at(at_fraction: float, at_position: Vec2, with_normal: Vec2, of: Feature) -> Impact:
	var impact := Impact.new()
	impact.hit = true
	impact.outcome = Outcome.HIT
	impact.fraction = at_fraction
	impact.position = at_position
	impact.normal = with_normal
	impact.feature = of
	return impact
