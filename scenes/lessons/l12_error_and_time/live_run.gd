@abstract class_name LiveRun
extends RefCounted
## Work that is done in small parts, so that the window stays alive. It can be stopped and resumed.

## Whether the work is under way. False before the start, after a stop, and at the end.
var is_going := false

## How many parts there are.
@abstract func size() -> int

## How many parts are done.
@abstract func done_count() -> int

## Does the next part.
@abstract func do_next() -> void


## Does parts for about [param microseconds], but at least one; stops after the last part.
func advance(microseconds: int) -> void:
	var start := Time.get_ticks_usec()
	while is_going:
		do_next()
		is_going = not is_done()
		if Time.get_ticks_usec() - start >= microseconds:
			return


## Whether all parts are done.
func is_done() -> bool:
	return done_count() >= size()


## The share of the parts that are done, 0..1.
func share() -> float:
	return float(done_count()) / size()
