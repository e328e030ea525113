class_name DiscreteDetection
extends RefCounted
## A ball that moves straight at a line, frame by frame, and a test that looks once a frame.

## Where the test calls the ball red: closer than r, behind the line too; only above the line; on
## both sides alike.
enum Rule { BELOW_RADIUS, ONLY_ABOVE, BOTH_SIDES }

## No flight is shown for longer.
const MOST_FRAMES := 12
## In pixels a frame.
const LARGEST_SPEED := 1e6

## Signed distance of the centre in frame 0, in pixels.
var distance: float
## The ball's radius, in pixels.
var radius: float
## By how much the distance shrinks in each frame, in pixels.
var speed: float
## The test.
var rule: Rule


## A flight that begins at [param its_distance] from the line.
func _init(its_distance: float, its_radius: float, its_speed: float, its_rule: Rule) -> void:
	distance = its_distance
	radius = its_radius
	speed = its_speed
	rule = its_rule


## The last frame that is shown: the ball is behind the line then, wholly, unless it takes too long.
func last_frame() -> int:
	return clampi(ceili(minf((distance + radius) / speed, MOST_FRAMES)), 1, MOST_FRAMES)


## The distance in [param frame], counted from 0.
func distance_at(frame: int) -> float:
	return distance - frame * speed


## Whether the test calls the ball red in [param frame].
func is_red(frame: int) -> bool:
	var at := distance_at(frame)
	match rule:
		Rule.ONLY_ABOVE:
			return at >= 0.0 and at < radius
		Rule.BOTH_SIDES:
			return absf(at) < radius
	return at < radius


## In how many of the frames up to [param frame] the ball is red.
func red_count(frame: int) -> int:
	var count := 0
	for i: int in frame + 1:
		count += int(is_red(i))
	return count


## Whether the ball comes from the good side, is behind the line in the end, and was never red.
func is_never_seen() -> bool:
	var last := last_frame()
	return distance > 0.0 and distance_at(last) < 0.0 and red_count(last) == 0
