class_name TwoBlocks
extends RefCounted
## Digits of pi from two blocks and a wall: a heavy block slides without friction towards a light
## one that lies between it and the wall. All impacts are elastic. For a mass ratio of 100^n the
## number of impacts spells the first n + 1 digits of pi (Galperin, Playing Pool with Pi, 2003).
##
## Nothing here knows that: the next impact is the earlier one of two, worked out from positions and
## velocities, and both blocks are moved there. All on one axis, in pixels from the wall; the light
## block's mass is 1. The blocks have no width: it would only shift the heavy one.

## Where the light block lies at first, in pixels from the wall.
const LIGHT_START := 100.0
## Where the heavy block is at first.
const HEAVY_START := 200.0
## How fast the heavy block comes, in pixels per second: towards the wall is negative.
const HEAVY_SPEED := -100.0

## The heavy block's mass, in masses of the light one.
var mass_ratio := 1.0
## Seconds since the start.
var time := 0.0
## The light block's place, in pixels from the wall.
var light_x := LIGHT_START
## The light block's velocity.
var light_velocity := 0.0
## The heavy block's place, in pixels from the wall.
var heavy_x := HEAVY_START
## The heavy block's velocity.
var heavy_velocity := HEAVY_SPEED
## Impacts so far: of the blocks with each other and of the light one with the wall.
var impacts := 0


## Begins anew with the heavy block [param ratio] times as heavy as the light one, above 0 and at
## most 1e16. "" or one sentence; then nothing has changed.
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


## Seconds from now until the light block meets the wall; INF if it does not move towards it.
func time_to_wall() -> float:
	return light_x / -light_velocity if light_velocity < 0.0 else INF


## Seconds from now until the blocks meet; INF if they do not come closer.
func time_to_block() -> float:
	var approach := light_velocity - heavy_velocity
	return (heavy_x - light_x) / approach if approach > 0.0 else INF


## Whether no impact will follow: both move away, the heavy one in front.
func is_over() -> bool:
	return time_to_wall() == INF and time_to_block() == INF


## Moves both blocks to the next impact and lets it happen; does nothing when all is over.
func advance_to_next_impact() -> void:
	var to_wall := time_to_wall()
	var to_block := time_to_block()
	if to_block < to_wall:
		_move(to_block)
		light_x = heavy_x
		_bounce_off_each_other()
	elif to_wall < INF:
		_move(to_wall)
		light_x = 0.0
		light_velocity = -light_velocity
		impacts += 1


## The energy of both in px^2/s^2, for a light block of mass 1.
func energy() -> float:
	var light := light_velocity * light_velocity
	return (light + mass_ratio * heavy_velocity * heavy_velocity) / 2.0


## How far the energy is from what it was at the start, as a share of it.
func energy_drift() -> float:
	return energy() / (mass_ratio * HEAVY_SPEED * HEAVY_SPEED / 2.0) - 1.0


## Lets at most [param most] impacts happen; false when all is over.
##
## It gives the same bits as that number of calls of [method advance_to_next_impact]; a test
## compares. It is written out in local variables, because 31 million impacts are to take seconds.
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


func _move(seconds: float) -> void:
	time += seconds
	light_x += light_velocity * seconds
	heavy_x += heavy_velocity * seconds


# Newton: the heavy block takes over 2 m / (m + M) of the approach; then they part as fast as they
# came together. Written in this way the rounding does not add up: worked out for the light block
# by itself, the energy is off by 2e-9 after the 31 million impacts of n = 7.
func _bounce_off_each_other() -> void:
	var approach := light_velocity - heavy_velocity
	heavy_velocity += approach * (2.0 / (1.0 + mass_ratio))
	light_velocity = heavy_velocity - approach
	impacts += 1
