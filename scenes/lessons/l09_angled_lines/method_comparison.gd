class_name MethodComparison
extends RefCounted
## The same world stepped in each of the four ways for a minute: what becomes of its energy, and the
## run time of a frame. It is done in small slices, so that the window stays alive.

## Frames that are compared: 60 seconds.
const FRAMES := 3600

var _worlds: Array[SteppedWorld] = []
var _first_energy := 0.0
var _microseconds: PackedFloat64Array = []
var _refusals: PackedStringArray = []


## Begins anew with copies of [param world].
func begin(world: SteppedWorld) -> void:
	_worlds.clear()
	_first_energy = world.energy()
	_microseconds.resize(SteppingMethods.Method.size())
	_microseconds.fill(0.0)
	_refusals.resize(SteppingMethods.Method.size())
	_refusals.fill("")
	for method: int in SteppingMethods.Method.size():
		var copy := world.copy()
		copy.mover = SteppingMethods.mover_of(method as SteppingMethods.Method)
		_worlds.append(copy)


## Steps on for about [param microseconds], with frames of [param seconds]. False when all is done.
func advance(microseconds: int, seconds: float) -> bool:
	var start := Time.get_ticks_usec()
	while _worlds[-1].frames < FRAMES and Time.get_ticks_usec() - start < microseconds:
		for method in _worlds.size():
			_step(method, seconds)
	return _worlds[-1].frames < FRAMES


## How many frames each way has made so far.
func frames() -> int:
	return _worlds[-1].frames


## The energy now as a share of that at the start; NaN where there was none, or where a ball has
## taken its energy along.
func energy_share(method: SteppingMethods.Method) -> float:
	if lost_count(method) > 0 or _first_energy <= 0.0:
		return NAN
	return _worlds[method].energy() / _first_energy


## How many balls that way of stepping has lost.
func lost_count(method: SteppingMethods.Method) -> int:
	return _worlds[method].lost_count()


## Whether the energy should stay the same: a bounce loses none.
func keeps_energy() -> bool:
	return _worlds[0].surroundings.bounciness == 1.0


## Why that way of stepping did not bring all balls to the end of a frame; "" if it always did.
func refusal(method: SteppingMethods.Method) -> String:
	return _refusals[method]


## Microseconds for one frame of all balls, the average so far.
func microseconds_per_frame(method: SteppingMethods.Method) -> float:
	return _microseconds[method] / maxf(_worlds[method].frames, 1.0)


func _step(method: int, seconds: float) -> void:
	var start := Time.get_ticks_usec()
	var problem := _worlds[method].step(seconds)
	_microseconds[method] += Time.get_ticks_usec() - start
	if problem and not _refusals[method]:
		_refusals[method] = problem
