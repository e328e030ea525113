class_name LastBounces
extends RefCounted
## When the bounces of a ball that gravity presses on a surface are over. A ball that leaves with
## the speed v along the normal, and is pressed back with the acceleration p, is back after 2 v / p;
## all bounces together, of which there are infinitely many, take 2 v / (p (1 - C)).

## A ball whose remaining bounces on a line would all be over within this time, in seconds, lies on
## the line from the end of the last one.
const REST_TIME := 1e-9
## A ball that would be in the air for less than this time, in seconds, lies, too, whatever C is.
const REST_HOP := 1e-12
## From this C on bounces die down too slowly: they end where they are no higher than LOWEST_HOP.
const NEARLY_ELASTIC := 0.999
## A nearly elastic ball whose bounces are no higher than this, in pixels, slides; so does any ball
## on a cap.
const LOWEST_HOP := 1e-9
## A nearly elastic ball that loses no more than this share of its energy by its last hop keeps it.
const LEAST_LOSS := 1e-6


## Whether a ball that leaves a line with this speed, in px/s, lies on it from now on.
static func are_over(speed: float, pressure: float, bounciness: float) -> bool:
	var least := maxf(REST_HOP, REST_TIME * (1.0 - bounciness))
	return speed <= 0.5 * pressure * least


## Whether the bounces of a nearly elastic ball on a line are too low to be seen.
static func are_too_low(speed: float, pressure: float, bounciness: float) -> bool:
	return bounciness > NEARLY_ELASTIC and is_lowest(speed, pressure)


## Whether a ball that leaves with this speed rises by no more than LOWEST_HOP.
static func is_lowest(speed: float, pressure: float) -> bool:
	return speed * speed <= 2.0 * pressure * LOWEST_HOP


## How long all remaining bounces take, in seconds.
static func duration(speed: float, pressure: float, bounciness: float) -> float:
	return 2.0 * speed / (pressure * (1.0 - bounciness)) if bounciness < 1.0 else 0.0
