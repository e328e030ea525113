class_name FuzzShrinker
extends RefCounted
## Makes a world that has a problem as small as can be, while it keeps a problem of the same sort:
## fewest edits, balls and lines, then the roundest numbers.

## So many worlds are judged at most for one that is made smaller.
const MOST_TRIES := 800

var _kind: FuzzKind
var _sort := ""
var _best: FuzzWorld
var _tries := 0


## The smallest world with the problem of [param world]; a copy of it where it has none.
static func smallest(kind: FuzzKind, world: FuzzWorld) -> FuzzWorld:
	var shrinker := FuzzShrinker.new()
	shrinker._kind = kind
	shrinker._best = world.copy()
	shrinker._sort = FuzzKind.sort_of(kind.problem_of(world))
	if shrinker._sort:
		shrinker._shrink()
	return shrinker._best


func _shrink() -> void:
	var again := true
	while again:
		again = _shorten()
		again = (
			_drop(func(world: FuzzWorld) -> int: return world.edits.size(), _without_edit) or again
		)
		again = (
			_drop(func(world: FuzzWorld) -> int: return world.balls.size(), _without_ball) or again
		)
		again = (
			_drop(func(world: FuzzWorld) -> int: return world.lines.size(), _without_line) or again
		)
		again = (
			_drop(func(world: FuzzWorld) -> int: return world.walls.size(), _without_walls) or again
		)
		again = _round_numbers() or again


# Takes this world for the best one, if it can be used and has the problem.
func _take(world: FuzzWorld) -> bool:
	if _tries >= MOST_TRIES or world.problem():
		return false
	_tries += 1
	if FuzzKind.sort_of(_kind.problem_of(world)) != _sort:
		return false
	_best = world
	return true


# What comes first takes the least time to judge.
func _shorten() -> bool:
	var has_changed := false
	var shorter := _best.copy()
	shorter.seconds *= 0.5
	while shorter.seconds > 1e-3 and _take(shorter):
		has_changed = true
		shorter = _best.copy()
		shorter.seconds *= 0.5
	return has_changed


# Leaves out as many things as can be: halves first, then ever smaller parts.
func _drop(count_of: Callable, without: Callable) -> bool:
	var has_changed := false
	var count: int = count_of.call(_best)
	var part := count
	while part > 0:
		var at := count - part
		while at >= 0:
			var fewer := _best.copy()
			for index: int in range(at + part - 1, at - 1, -1):
				without.call(fewer, index)
			has_changed = _take(fewer) or has_changed
			at -= part
		count = count_of.call(_best)
		part = mini(part >> 1, count)
	return has_changed


# Equal numbers stay equal, so that joints stay joints.
func _round_numbers() -> bool:
	var has_changed := false
	var seen: Dictionary[float, bool] = {}
	for number: float in _best.numbers():
		if seen.has(number):
			continue
		seen[number] = true
		for rounder: float in _rounder_than(number):
			var rounded := _best.copy()
			var numbers := rounded.numbers()
			for at: int in numbers.size():
				if numbers[at] == number:
					numbers[at] = rounder
			rounded.put_numbers(numbers)
			if _take(rounded):
				has_changed = true
				break
	return has_changed


# Numbers near to this one with fewer digits, the roundest first.
func _rounder_than(number: float) -> PackedFloat64Array:
	var found: PackedFloat64Array = []
	if number == 0.0 or not is_finite(number):
		return found
	var length := DecimalText.of(absf(number)).length()
	var candidates: PackedFloat64Array = [0.0, signf(number), signf(number) * 10.0]
	var size := floori(log(absf(number)) / log(10.0))
	for digits: int in [1, 2, 3, 4, 6]:
		# Read from a text: a power of ten times a whole number would have other last bits.
		var scale := 10.0 ** (digits - 1 - size)
		var whole := roundf(number * scale)
		if is_finite(whole):
			candidates.append(DecimalText.value_of("%de%d" % [whole, size + 1 - digits]))
	for candidate: float in candidates:
		if absf(candidate) < absf(number) * 3.0 and not is_nan(candidate):
			if DecimalText.of(absf(candidate)).length() < length and not found.has(candidate):
				found.append(candidate)
	return found


static func _without_walls(world: FuzzWorld, _index: int) -> void:
	world.walls.clear()


static func _without_line(world: FuzzWorld, place: int) -> void:
	world.lines.remove_at(place)
	_close_gap(world, place, 0, true)


static func _without_ball(world: FuzzWorld, place: int) -> void:
	world.balls.remove_at(place)
	_close_gap(world, place, 0, false)


# Later edits name things by their places; one that is added comes behind all others.
static func _without_edit(world: FuzzWorld, index: int) -> void:
	var edit := world.edits[index]
	var place := -1
	if edit.kind == FuzzEdit.Kind.ADD_LINE:
		place = world.lines.size()
	elif edit.kind == FuzzEdit.Kind.ADD_BALL:
		place = world.balls.size()
	for earlier: int in index:
		place += int(world.edits[earlier].kind == edit.kind)
	world.edits.remove_at(index)
	if edit.kind == FuzzEdit.Kind.ADD_LINE or edit.kind == FuzzEdit.Kind.ADD_BALL:
		_close_gap(world, place, index, edit.kind == FuzzEdit.Kind.ADD_LINE)


# The thing at this place is gone: what is done to it goes, too, and those behind it move up.
static func _close_gap(world: FuzzWorld, place: int, from: int, is_line: bool) -> void:
	for index: int in range(world.edits.size() - 1, from - 1, -1):
		var edit := world.edits[index]
		if edit.names_line() if is_line else edit.names_ball():
			if edit.place == place:
				world.edits.remove_at(index)
			elif edit.place > place:
				edit.place -= 1
