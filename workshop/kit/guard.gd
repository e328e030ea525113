class_name WorkshopGuard
extends RefCounted
## What keeps a student's code within bounds where no child process can be ended: in a browser.
## [WorkshopGuardedCode] writes calls of these methods into the text that is run, in memory only. An
## instance counts as a call that has not returned yet.
##
## Nothing stops code from outside here. So what would stop the whole page is prevented, and once a
## bound is passed every loop ends at its next turn, and every method at its first line.

## So many turns of loops belong to one probe, and as many calls.
const MOST_TURNS := 100_000
## So many calls may be within each other.
const DEEPEST := 200
## So many elements may be made at once, or added by copies of whole lists.
const MOST_ELEMENTS := 2_000_000
## So many characters a text may have, and so many elements a list that is built up.
const LARGEST := 200_000
## So many lines that are printed are kept.
const MOST_PRINTED := 6

## Whether a bound was passed since [method begin].
static var over := false
## Which one: ENDLESS or MEMORY.
static var kind := WorkshopVerdict.Kind.ENDLESS
## The line of the student's file in which that was.
static var line := 0
## The first lines that were printed since [method forget_prints].
static var printed: PackedStringArray = []
## How many there were.
static var print_count := 0

static var _errors: WorkshopHeardErrors
static var _turns := 0
static var _calls := 0
static var _depth := 0
static var _elements := 0


## From now on the bounds begin anew. What stops a method is told to [param errors]; [param times]
## calls one after the other may have more turns.
static func begin(errors: WorkshopHeardErrors, times: int = 1) -> void:
	_errors = errors
	over = false
	line = 0
	# Many calls in a row are many short ones.
	_turns = -floori(MOST_TURNS * (times - 1) / 10.0)
	_calls = _turns
	_depth = 0
	_elements = 0


## Forgets what was printed.
static func forget_prints() -> void:
	printed.clear()
	print_count = 0


## Whether a loop may make one more turn.
static func turn(at: int) -> bool:
	_turns += 1
	if _turns > MOST_TURNS:
		_stop(WorkshopVerdict.Kind.ENDLESS, at)
	return not over


## One more call begins; it ends when nobody holds what this returns.
static func enter(at: int) -> WorkshopGuard:
	_calls += 1
	if _depth >= DEEPEST:
		_errors.has_overflowed = true
		_stop(WorkshopVerdict.Kind.ENDLESS, at)
	elif _calls > MOST_TURNS:
		_stop(WorkshopVerdict.Kind.ENDLESS, at)
	return WorkshopGuard.new()


## What is taken off a divisor so that no whole number is divided by 0: 0, or -1 for a whole 0. What
## follows it counts no more.
static func shift(divisor: Variant, at: int) -> int:
	if divisor is int and divisor == 0:
		_note("Division by zero error", at)
		return -1
	return 0


## A whole divisor in place of one that is 0.
static func whole_divisor(divisor: int, at: int) -> int:
	return divisor - shift(divisor, at)


## A divisor of any kind in place of a whole one that is 0.
static func any_divisor(divisor: Variant, at: int) -> Variant:
	return 1 if shift(divisor, at) else divisor


## The engine's `posmod`, but for 0.
static func rest(dividend: int, divisor: int, at: int) -> int:
	return posmod(dividend, whole_divisor(divisor, at))


## Whether [param base] has [param member], a method where [param is_called]. If not it is told as
## the engine does where it is built for tests.
static func has(base: Variant, member: StringName, is_called: bool, at: int) -> bool:
	if typeof(base) == TYPE_OBJECT:
		var object := WorkshopAny.object(base)
		if object and (object.has_method(member) if is_called else member in object):
			return true
	elif not typeof(base) in [TYPE_NIL, TYPE_BOOL, TYPE_INT, TYPE_FLOAT]:
		return true
	var is_freed := typeof(base) == TYPE_OBJECT and not is_instance_valid(base)
	if typeof(base) == TYPE_NIL or is_freed:
		_note("Invalid access to '%s' on a null instance" % member, at)
	else:
		var form := "Nonexistent function '%s'" if is_called else "Invalid access to key '%s'"
		_note(form % member, at)
	return false


## The same for what a call has given, which is given back.
static func given(base: Variant, member: StringName, is_called: bool, at: int) -> Variant:
	has(base, member, is_called, at)
	return base


## A limit of a range for a loop, which counts its turns itself.
static func limit(number: float) -> int:
	return int(clampf(number, -1e6, 1e6))


## The size of a list, or a limit of a range that is made as a list.
static func extent(number: float, at: int) -> int:
	_add_elements(absf(number), at)
	return 0 if over else int(number)


## A list that is added to another one: nothing of it where there are too many.
static func added(list: Variant, at: int) -> Variant:
	if not _is_list(list):
		return list
	var size: int = len(list)
	_add_elements(size, at)
	return type_convert([], typeof(list)) if over else list


## Looks whether a text or a list has grown too large.
static func look(value: Variant, at: int) -> void:
	if (value is String or _is_list(value)) and len(value) > LARGEST:
		_stop(WorkshopVerdict.Kind.MEMORY, at)


## The engine's `assert`.
static func claim(holds: Variant, message: String, at: int) -> void:
	if not holds:
		_note("Assertion failed" + (": " + message if message else "."), at)


## The engine's `print` and all that is like it.
static func say(...parts: Array) -> void:
	print_count += 1
	if printed.size() < MOST_PRINTED and not over:
		printed.append("".join(parts.map(func(part: Variant) -> String: return str(part))))


func _init() -> void:
	_depth += 1


func _notification(what: int) -> void:
	if what == NOTIFICATION_PREDELETE:
		_depth -= 1


static func _is_list(value: Variant) -> bool:
	return typeof(value) >= TYPE_ARRAY


static func _add_elements(count: float, at: int) -> void:
	if _elements + count > MOST_ELEMENTS:
		_stop(WorkshopVerdict.Kind.MEMORY, at)
	else:
		_elements += int(count)


static func _stop(its_kind: WorkshopVerdict.Kind, at: int) -> void:
	if not over:
		over = true
		kind = its_kind
		line = at


static func _note(message: String, at: int) -> void:
	if not over:
		_errors.add(message, at)
