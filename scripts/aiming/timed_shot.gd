class_name TimedShot
extends RefCounted
## When to fire, or why never. Read [member hit] first: without a hit, only [member outcome] has a
## meaning.

## When to fire, or why never: the way of the bullet and that of the target are parallel, so that
## they meet never or always; they do not cross; they cross, but not in time.
enum Outcome { HIT, PARALLEL, NO_CROSSING, NOT_IN_TIME }

## Whether there is such a moment.
var hit := false
## Seconds until the shot.
var fire := 0.0
## Seconds from the shot to the hit.
var flight := 0.0
## When to fire, or why never.
var outcome := Outcome.NO_CROSSING


## A result without a hit, for the reason [param reason].
static func miss(reason: Outcome) -> TimedShot:
	var shot := TimedShot.new()
	shot.outcome = reason
	return shot


## A shot after [param at] seconds that hits [param flown] seconds later.
static func at(at_seconds: float, flown: float) -> TimedShot:
	var shot := TimedShot.new()
	shot.hit = true
	shot.outcome = Outcome.HIT
	shot.fire = at_seconds
	shot.flight = flown
	return shot
