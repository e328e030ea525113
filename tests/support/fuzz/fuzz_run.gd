class_name FuzzRun
extends RefCounted
## Tries one random world after the other, of all kinds in turn, and keeps what fails, made as small
## as can be.

## One run has fewer worlds than this; the runs of two seeds share none.
const NUMBERS_PER_SEED := 10_000_000
## Of each sort of problem so many are made small; more are only counted.
const MOST_OF_ONE_SORT := 2

## What has been found, in order.
var finds: Array[FuzzFind] = []
## The worlds tried so far.
var tried := 0

var _kinds: Array[FuzzKind] = []
var _seed := 1
var _counts: Dictionary[String, int] = {}


func _init(kinds: Array[FuzzKind], seed_number: int) -> void:
	_kinds = kinds
	_seed = seed_number


## All kinds of worlds.
static func all_kinds() -> Array[FuzzKind]:
	return [
		ChainKind.new(),
		SteppedChainKind.new(SteppingMethods.Method.WHOLE_FRAME),
		SteppedChainKind.new(SteppingMethods.Method.POSITION_RESET),
		SteppedChainKind.new(SteppingMethods.Method.POINT_OF_IMPACT),
		EditKind.new(),
		SteppedEditKind.new(),
		FastPathKind.new(),
		PileKind.new(),
		LeadShotKind.new(),
		BallisticShotKind.new(),
		MovingShotKind.new(),
		BankShotKind.new(),
		LineTimingKind.new(),
		CircleTimingKind.new(),
		TurningTimingKind.new(),
		FrictionKind.new(),
		MovingKind.new(),
	]


## The kind of the next world.
func next_kind() -> FuzzKind:
	return _kinds[tried % _kinds.size()]


## The number of the next world. All kinds have a turn with each number.
func next_number() -> int:
	return _seed * NUMBERS_PER_SEED + floori(tried / float(_kinds.size()))


## Tries the next world. What it finds is null where all holds, or where that is known by now.
func try_next() -> FuzzFind:
	var kind := next_kind()
	var number := next_number()
	tried += 1
	var world := kind.world_of(number)
	var problem := kind.problem_of(world)
	if not problem:
		return null
	var sort := kind.name + FuzzKind.sort_of(problem)
	_counts[sort] = _counts.get(sort, 0) + 1
	if _counts[sort] > MOST_OF_ONE_SORT:
		return null
	var find := FuzzFind.new(kind, number, FuzzShrinker.smallest(kind, world))
	finds.append(find)
	return find


## How many worlds had a problem, those that were only counted included.
func count() -> int:
	var sum := 0
	for sort: String in _counts:
		sum += _counts[sort]
	return sum


## What the kinds have measured, a line each; "" where none has.
func figures_text() -> String:
	var parts: PackedStringArray = []
	for kind: FuzzKind in _kinds:
		if kind.figures():
			parts.append(kind.figures())
	return "\n".join(parts)


## How many had each sort of problem, a line each.
func counts_text() -> String:
	var parts: PackedStringArray = []
	for sort: String in _counts:
		parts.append("%d x %s" % [_counts[sort], sort])
	return "\n".join(parts)
