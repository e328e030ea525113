class_name Friction
extends RefCounted
## Coulomb's law of friction for a disc that touches something.
##
## The slip is how fast the two surfaces rub along each other. Friction works against it, with at
## most µ times what presses. If that is enough to end the slip, the surfaces stick; if not, they
## slip on, and friction is µ times what presses. There is one µ: nothing tells a surface that has
## stuck before from one that slips.

## What a contact does: nothing, the surfaces slip along each other, or they stick.
enum Regime { NONE, SLIP, STICK }

## No number of an impact with friction may be larger than this, in pixels, seconds and radians; nor
## a distance times a speed: else their squares could be too large for a double.
const LARGEST := 1e152

## How much slip an impulse of 1 per mass along the surface takes away: 1 by the flight and
## 1 / [constant Disc.INERTIA] = 2 by the spin.
const YIELD := 1.0 + 1.0 / Disc.INERTIA


## Whether the surfaces stick or slip. [param slip] is in px/s, [param push] is the impulse along
## the normal per mass, in px/s and 0 or more; [param friction] is µ. Without friction everything
## slips, also where the slip is 0.
static func regime(slip: float, push: float, friction: float) -> Regime:
	if friction > 0.0 and absf(slip) <= YIELD * friction * push:
		return Regime.STICK
	return Regime.SLIP


## The impulse along the surface, per mass, in px/s: it is against the slip. Arguments as for
## [method regime].
static func impulse(slip: float, push: float, friction: float) -> float:
	if regime(slip, push, friction) == Regime.STICK:
		return -slip / YIELD
	return -signf(slip) * friction * push


## "" if [param friction] can be used as µ, which must be within 0..[param largest]; otherwise one
## sentence with the value and what is allowed.
static func problem_of(friction: float, largest: float = LARGEST) -> String:
	if friction >= 0.0 and friction <= largest:
		return ""
	var limit := String.num_scientific(largest)
	return "The friction µ must be within 0..%s, not %s." % [limit, friction]


## "" if an impact can be found at this distance, in pixels, and with this speed, in px/s; otherwise
## one sentence with the values and what is allowed.
static func problem_of_sizes(distance: float, speed: float) -> String:
	if distance * speed <= LARGEST:
		return ""
	var values := [String.num_scientific(LARGEST), distance, speed]
	return "Distance times speed must be at most %s px²/s, not %s px times %s px/s." % values
