class_name InclineRun
extends RefCounted
## Where a ball on an [Incline] is, and how it moves there.

## Whether the ball has come to an end of the line, and to which one.
enum End { NONE, START, END }

## How the ball moves: it slips as it began; it rolls; it slips the other way than it began.
enum Regime { SLIPS, ROLLS, SLIPS_BACK }

## The end of the line at which the ball is; NONE if the time was over before.
var leaves := End.NONE
## How the ball moves at last.
var regime := Regime.SLIPS
## When the ball began to roll, in seconds; -1 if it did not.
var roll_time := -1.0
## Seconds since the start.
var time := 0.0
## Pixels from the start of the line to the point below the centre.
var distance: float
## The centre's speed from start to end, in pixels per second.
var speed: float
## Radians per second, clockwise on screen.
var spin: float
## Whether a ball that comes to an end flies off it at once: v² > N r. Otherwise it goes on over the
## round end.
var flies := false


## A ball at the start of its run.
func _init(at_distance: float, with_speed: float, with_spin: float) -> void:
	distance = at_distance
	speed = with_speed
	spin = with_spin


## Lets some seconds pass in which [param acceleration], in px/s², and the change of the spin,
## [param turning] in rad/s², are constant.
func move(seconds: float, acceleration: float, turning: float) -> void:
	distance += (speed + 0.5 * acceleration * seconds) * seconds
	speed += acceleration * seconds
	spin += turning * seconds
	time += seconds
