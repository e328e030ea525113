class_name InclinePhase
extends RefCounted
## A part of the way of a ball along an [Incline] in which nothing but its place, speed and spin
## changes: it slips in one direction, or it rolls.

## Whether the ball rolls; else it slips.
var rolls := false
## How the speed from start to end changes, in px/s².
var acceleration := 0.0
## How the spin changes, in rad/s².
var turning := 0.0
## Seconds until the slip is over; INF if it never is, or there is none.
var lasts := INF
