class_name TwoBlocks
extends RefCounted
## Digits of pi from two blocks and a wall: a heavy block slides without friction towards a light
## block that is at rest between it and the wall. All impacts are elastic. For a mass ratio of 100^n
## the number of impacts gives the first n + 1 digits of pi (Galperin, Playing Pool with Pi, 2003).
##
## The code makes no use of that: it finds the earlier one of the two next impacts from positions
## and velocities, and moves both blocks there. Everything happens on one axis, in pixels from the
## wall. The light block's mass is 1. The blocks have no width: it would only shift the heavy one.

## Where the light block is at the start, in pixels from the wall.
const LIGHT_START := 100.0
## Where the heavy block is at the start, in pixels from the wall.
const HEAVY_START := 200.0
## The heavy block's velocity at the start, in pixels per second; negative is towards the wall.
const HEAVY_SPEED := -100.0

## The heavy block's mass; the light block's mass is 1.
var mass_ratio := 1.0
## Seconds since the start.
var time := 0.0
## The light block's position, in pixels from the wall.
var light_x := LIGHT_START
## The light block's velocity, in pixels per second.
var light_velocity := 0.0
## The heavy block's position, in pixels from the wall.
var heavy_x := HEAVY_START
## The heavy block's velocity, in pixels per second.
var heavy_velocity := HEAVY_SPEED
## Impacts so far: of the blocks with each other, and of the light block with the wall.
var impacts := 0


## Starts again with a heavy block [param ratio] times as heavy as the light one, above 0 and at
## most 1e16. Returns "", or one sentence; then nothing has changed.
func start(ratio: float) -> String:
	if not (ratio > 0.0 and ratio <= 1e16):
		return "The mass ratio must be above 0 and at most 1e16, not %s." % ratio
	mass_ratio = ratio
	time = 0.0
	light_x = LIGHT_START
	light_velocity = 0.0
	heavy_x = HEAVY_START
	heavy_velocity = HEAVY_SPEED
	impacts = 0
	return ""


## The energy of both in px^2/s^2.
func energy() -> float:
	var light := light_velocity * light_velocity
	return (light + mass_ratio * heavy_velocity * heavy_velocity) / 2.0


## The change of the energy since the start, as a fraction of the energy at the start.
func energy_drift() -> float:
	return energy() / (mass_ratio * HEAVY_SPEED * HEAVY_SPEED / 2.0) - 1.0


## Lets at most [param most] impacts happen. Returns false if fewer happen: then no impact follows,
## because the light block does not catch up with the heavy one.
##
## Plain local numbers, because 31 million impacts should take seconds. When the blocks meet, the
## heavy one takes over 2 m / (m + M) of the approach; then they part as fast as they came together.
## In this form rounding does not add up: computing the light block's velocity on its own leaves the
## energy off by 2e-9 after 31 million impacts.
func run(most: int) -> bool:
	var light := light_x
	var heavy := heavy_x
	var light_speed := light_velocity
	var heavy_speed := heavy_velocity
	var share := 2.0 / (1.0 + mass_ratio)
	var now := time
	var left := most
	while left > 0:
		var approach := light_speed - heavy_speed
		if approach > 0.0:
			var to_block := (heavy - light) / approach
			if light_speed >= 0.0 or to_block < light / -light_speed:
				heavy += heavy_speed * to_block
				light = heavy
				heavy_speed += approach * share
				light_speed = heavy_speed - approach
				now += to_block
				left -= 1
				continue
		if light_speed >= 0.0:
			break
		var to_wall := light / -light_speed
		heavy += heavy_speed * to_wall
		light = 0.0
		light_speed = -light_speed
		now += to_wall
		left -= 1
	light_x = light
	heavy_x = heavy
	light_velocity = light_speed
	heavy_velocity = heavy_speed
	time = now
	impacts += most - left
	return left == 0
