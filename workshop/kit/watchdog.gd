class_name WorkshopWatchdog
extends RefCounted
## Ends the child in which it lives when the student's code does not come to an end, or takes too
## much memory. It runs in a thread of its own, which goes on while the code loops.

## Seconds for one exercise: a right answer takes less than a tenth of that, even where the machine
## has other work to do.
const LONGEST := 1.0
## Bytes that the code may take.
const MOST_MEMORY := 400_000_000

# Bytes that no code takes which only loops.
const _MUCH_MEMORY := 50_000_000

# Milliseconds from one look to the next. A longer way counts as no more than twice that: what stops
# this thread as well, such as a machine that pauses, is not the student's doing.
const _LOOK_EVERY := 10

## Called in the thread just before the end with the kind of the verdict, ENDLESS or MEMORY.
var last_words: Callable

var _thread := Thread.new()
# Milliseconds since the start, but for pauses. Only the thread changes it.
var _clock := 0
# When the time is over; negative while nothing is timed. Only the student's thread changes it.
var _deadline := -1
var _memory_before := 0
var _runs := true


## Begins to watch; nothing is timed yet.
func start() -> void:
	_memory_before = OS.get_static_memory_usage()
	var problem := _thread.start(_watch)
	assert(problem == OK, "the watching thread has started")


## Gives the code that runs from now on [param seconds].
func allow(seconds: float) -> void:
	_deadline = _clock + int(seconds * 1000.0)


## Nothing of the student's runs any more.
func rest() -> void:
	_deadline = -1


## Ends the thread.
func stop() -> void:
	_runs = false
	_thread.wait_to_finish()


func _watch() -> void:
	var before := Time.get_ticks_msec()
	while _runs:
		OS.delay_msec(_LOOK_EVERY)
		var now := Time.get_ticks_msec()
		_clock += mini(now - before, 2 * _LOOK_EVERY)
		before = now
		# The other thread may change it between two looks.
		var deadline := _deadline
		if deadline < 0:
			continue
		var taken := OS.get_static_memory_usage() - _memory_before
		if taken > MOST_MEMORY:
			_end(WorkshopVerdict.Kind.MEMORY)
		elif _clock > deadline:
			# A slow machine may not get as far as that.
			var is_growing := taken > _MUCH_MEMORY
			_end(WorkshopVerdict.Kind.MEMORY if is_growing else WorkshopVerdict.Kind.ENDLESS)


func _end(kind: WorkshopVerdict.Kind) -> void:
	last_words.call(kind)
	OS.kill(OS.get_process_id())
