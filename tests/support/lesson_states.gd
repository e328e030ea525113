class_name LessonStates
extends RefCounted
## States of a lesson's board that a student can reach: presets, mistakes, switches, and random and
## extreme numbers of every kind that the lesson's link knows. The same for the same seed.
##
## Knows no lesson: of three points of a state, one is laid by the others - on them, parallel,
## perpendicular, nearly so, behind, far beyond.

# Along the way from one point to another, and across it: 0, 1 and -1 are the special places.
const _SHARES: Array[float] = [0.0, 1.0, -1.0, 0.5, -0.4, 1.6, 2.0, -1e-3, 1e-12, 1.0 + 1e-12]
const _NEARLY: Array[float] = [1e-3, 1e-7, 1e-12, 1e-4, 1e-5, 1e-9]
const _SIZES: Array[float] = [1e15, 1e-12, 1e6, 1e-3, 3e7, 0.1]
const _NUMBERS: Array[float] = [0.0, 1.0, 0.5, 2.0, -0.4, 1.0 / 3.0, 1e-3, 1e-12]
# A state that the lesson cannot show is drawn again, so often at most.
const _TRIES := 40

## The link states of the lesson's start, its presets, its choices and its mistakes.
var bases: Array[Dictionary] = []

var _lesson: Lesson
var _rng := RandomNumberGenerator.new()
# For each value by its name the values that were seen.
var _seen: Dictionary[String, Array] = {}


## States of [param lesson], which has been started; it is left as it was.
func _init(lesson: Lesson, seed_number: int) -> void:
	_lesson = lesson
	_rng.seed = seed_number
	var first := lesson.state().duplicate(true)
	_keep()
	_visit(&"options", "%Presets")
	_visit(&"options", "%Switches")
	_visit(&"mistakes", "%List")
	lesson.show_state(first)


## The state number [param number]: first the bases as they are, then changed ones.
func state(number: int) -> Dictionary:
	if number < bases.size():
		return bases[number]
	for i in _TRIES:
		var changed := _changed(bases[_rng.randi() % bases.size()])
		if not _lesson.link_problem(changed):
			return changed
	return bases[0]


# Presses all buttons, and chooses all items of all lists.
func _visit(service: StringName, place: String) -> void:
	if not _lesson.services.has(service):
		return
	var node := _lesson.services[service].get_node(place)
	for control: Node in node.get_children() + ([node] as Array[Node]):
		if control is OptionButton:
			for item in (control as OptionButton).item_count:
				(control as OptionButton).select(item)
				(control as OptionButton).item_selected.emit(item)
				_keep()
		elif control is CheckButton:
			for i in 2:
				(control as CheckButton).button_pressed = not (
					(control as CheckButton).button_pressed
				)
				_keep()
		elif control is Button:
			(control as Button).pressed.emit()
			_keep()


func _keep() -> void:
	var reached := _lesson.link_state().duplicate(true)
	if reached in bases:
		return
	bases.append(reached)
	for name: String in reached:
		var values: Array = _seen.get(name, [])
		if not reached[name] in values:
			values.append(reached[name])
		_seen[name] = values


func _changed(base: Dictionary) -> Dictionary:
	var found := base.duplicate(true)
	for name: String in found:
		if _rng.randf() < 0.5:
			found[name] = _value(name, found[name])
	_lay_points(found)
	return found


func _value(name: String, now: Variant) -> Variant:
	match typeof(now):
		TYPE_BOOL:
			return _rng.randf() < 0.3
		TYPE_INT, TYPE_STRING:
			return _pick(_seen[name])
		TYPE_FLOAT:
			return _number() if _rng.randf() < 0.5 else _pick(_NUMBERS)
		TYPE_PACKED_FLOAT64_ARRAY:
			var list: PackedFloat64Array = now
			return _list(list.size())
		TYPE_ARRAY:
			var lists: Array = now
			return _lists(lists)
	return now


func _list(length: int) -> PackedFloat64Array:
	var numbers: PackedFloat64Array = []
	for i in length:
		numbers.append(_number())
	return numbers


func _lists(now: Array) -> Array[PackedFloat64Array]:
	var lists: Array[PackedFloat64Array] = []
	for list: PackedFloat64Array in now:
		lists.append(_list(list.size()) if _rng.randf() < 0.3 else list)
	return lists


# A whole number, tenths, hundredths, or all the digits of a double.
func _number() -> float:
	match _rng.randi() % 8:
		0, 1, 2:
			return _rng.randi_range(-12, 12)
		3:
			return _rng.randi_range(-300, 300)
		4, 5:
			return _rng.randi_range(-999, 999) / 10.0
		6:
			return _rng.randi_range(-9999, 9999) / 100.0
	return (_rng.randi() / 2.0 ** 32 + _rng.randi() / 2.0 ** 64 - 0.5) * 40.0


# Lays one point of the state by one or two others, or changes the size of all.
func _lay_points(state_to_change: Dictionary) -> void:
	var places := _points(state_to_change)
	if places.is_empty():
		return
	match _rng.randi() % 8:
		0:
			_resize(state_to_change, places, _SIZES[_rng.randi() % _SIZES.size()])
		1:
			pass
		_:
			_lay_one(state_to_change, places)


# Where the state holds points: name and place of x. A list of odd length ends with a radius.
func _points(from: Dictionary) -> Array[Array]:
	var places: Array[Array] = []
	for name: String in from:
		if typeof(from[name]) == TYPE_PACKED_FLOAT64_ARRAY:
			var list: PackedFloat64Array = from[name]
			for at in range(0, list.size() - 1, 2):
				places.append([name, at])
	return places


func _lay_one(changed: Dictionary, places: Array[Array]) -> void:
	var laid: Array = _pick(places)
	var one: Array = _pick(places)
	var other: Array = _pick(places)
	var tail := Vec2.new()
	if places.size() > 2 and _rng.randf() < 0.6:
		tail = _point(changed, one)
	var head := _point(changed, other)
	var along := head.minus(tail)
	var share: float = _pick(_SHARES)
	var across: float = _pick([0.0, 0.0, 1.0, -1.0, _pick(_SHARES)])
	if _rng.randf() < 0.4:
		var side: float = _pick([1.0, -1.0])
		# Nearly across, or nearly along.
		if _rng.randf() < 0.5:
			share = _pick(_NEARLY) * side
		else:
			across = _pick(_NEARLY) * side
	var point := tail.plus(along.scaled(share)).plus(along.normal().scaled(across))
	_put(changed, laid, point)


func _resize(changed: Dictionary, places: Array[Array], factor: float) -> void:
	for place in places:
		_put(changed, place, _point(changed, place).scaled(factor))


func _point(from: Dictionary, place: Array) -> Vec2:
	var list: PackedFloat64Array = from[place[0]]
	var at: int = place[1]
	return Vec2.new(list[at], list[at + 1])


func _put(changed: Dictionary, place: Array, point: Vec2) -> void:
	var list: PackedFloat64Array = changed[place[0]]
	var at: int = place[1]
	list[at] = point.x
	list[at + 1] = point.y
	changed[place[0]] = list


func _pick(values: Array) -> Variant:
	return values[_rng.randi() % values.size()]
