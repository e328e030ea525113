@abstract class_name LiveRun
extends RefCounted
## Work that is done in small parts while the window stays alive: begun, stopped where it is, gone
## on with.

## It is to go on. False before it is begun, when it was stopped, and when it is done.
var is_going := false

## How many parts there are.
@abstract func size() -> int

## How many parts have been done.
@abstract func done_count() -> int

## Does the part that is next.
@abstract func do_next() -> void


## Does parts for about [param microseconds], at least one; ends by itself after the last.
func advance(microseconds: int) -> void:
	var start := Time.get_ticks_usec()
	while is_going:
		do_next()
		is_going = not is_done()
		if Time.get_ticks_usec() - start >= microseconds:
			return


## All has been done.
func is_done() -> bool:
	return done_count() >= size()


## The share of all parts that have been done, 0..1.
func share() -> float:
	return float(done_count()) / size()
