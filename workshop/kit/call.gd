class_name WorkshopCall
extends RefCounted
## Calls a method with plain numbers, and reads what comes back as plain numbers. The same for the
## student's class and for the lab's own, so that their run times compare.

const _BALL_NUMBERS := 7
const _LINE_NUMBERS := 4

var _task: WorkshopTask
var _vector: GDScript
var _home: GDScript
var _method: String
var _is_static := true
# A Callable does not hold its object.
var _held := []


## Prepares to call [param method] of [param home] for [param task], with vectors of the class
## [param vector].
func _init(task: WorkshopTask, vector: GDScript, home: GDScript, method: String) -> void:
	_task = task
	_vector = vector
	_home = home
	_method = method
	for known: Dictionary in home.get_script_method_list():
		if known["name"] == method:
			var flags: int = known["flags"]
			_is_static = flags & METHOD_FLAG_STATIC != 0


## What the lab's own code answers to a probe.
static func right_answer(task: WorkshopTask, probe: WorkshopProbe) -> PackedFloat64Array:
	return of_lab(task).run_probe(probe).numbers


## The lab's own method that answers [param task] right.
static func of_lab(task: WorkshopTask) -> WorkshopCall:
	var vector: GDScript = task.reference_home if task.is_of_vector() else Vec2
	return WorkshopCall.new(task, vector, task.reference_home, task.reference_method)


## Calls with the numbers of [param probe].
func run_probe(probe: WorkshopProbe) -> WorkshopAnswer:
	if probe.repeats > 1:
		return _energy_after(probe)
	return run(probe.numbers, probe.leaves_out_last)


## Calls with these numbers.
func run(numbers: PackedFloat64Array, leaves_out_last: bool = false) -> WorkshopAnswer:
	var inputs := inputs_of(numbers)
	var before := _numbers_of_vectors(inputs)
	var result: Variant = call_with(inputs, leaves_out_last)
	var answer := WorkshopAnswer.new()
	if _task.is_in_place():
		_read_changed(answer, inputs[0], result, before)
	else:
		_read_result(answer, result)
	var after := _numbers_of_vectors(inputs)
	var first := _numbers_changed_on_purpose()
	answer.spoiled = after.slice(first) != before.slice(first)
	return answer


## The objects and numbers that are handed over: for a method of the vector, that vector first.
func inputs_of(numbers: PackedFloat64Array) -> Array:
	var inputs := []
	var at := 0
	for index in _task.takes.length():
		match _task.takes[index]:
			"v":
				inputs.append(_vector_of(numbers[at], numbers[at + 1]))
				at += 2
			"B":
				inputs.append(_ball_of(numbers))
				at += _BALL_NUMBERS
			"L":
				var end := numbers.size() - (_task.takes.length() - 1 - index)
				inputs.append(_lines_of(numbers.slice(at, end)))
				at = end
			_:
				inputs.append(numbers[at])
				at += 1
	return inputs


## Calls with what [method inputs_of] made.
func call_with(inputs: Array, leaves_out_last: bool = false) -> Variant:
	var arguments := inputs.slice(1) if _task.is_of_vector() else inputs
	if leaves_out_last:
		arguments = arguments.slice(0, -1)
	return _receiver(inputs).callv(_method, arguments)


## A call with these numbers that is ready to be made many times, as long as this object is held.
func prepared(numbers: PackedFloat64Array) -> Callable:
	var inputs := inputs_of(numbers)
	_held = inputs
	var arguments := inputs.slice(1) if _task.is_of_vector() else inputs
	return Callable(_receiver(inputs), _method).bindv(arguments)


func _receiver(inputs: Array) -> Object:
	if _task.is_of_vector():
		return inputs[0]
	return _home if _is_static else _made(_home)


static func _made(script: GDScript) -> Object:
	return script.callv(&"new", [])


func _vector_of(x: float, y: float) -> Object:
	return _vector.callv(&"new", [x, y])


# A class inside the file.
func _inner(its_name: String) -> GDScript:
	return WorkshopAny.script(_home.get_script_constant_map().get(its_name))


func _ball_of(numbers: PackedFloat64Array) -> Object:
	var ball := _made(_inner("MyBall"))
	ball.set("position", _vector_of(numbers[0], numbers[1]))
	ball.set("velocity", _vector_of(numbers[2], numbers[3]))
	ball.set("radius", numbers[4])
	ball.set("acceleration", _vector_of(numbers[5], numbers[6]))
	return ball


func _lines_of(numbers: PackedFloat64Array) -> Array:
	var lines := []
	for at in range(0, numbers.size(), _LINE_NUMBERS):
		var line := _made(_inner("MySegment"))
		line.set("start", _vector_of(numbers[at], numbers[at + 1]))
		line.set("end", _vector_of(numbers[at + 2], numbers[at + 3]))
		lines.append(line)
	return lines


# Of the numbers of all vectors, how many belong to the input that is changed on purpose.
func _numbers_changed_on_purpose() -> int:
	match _task.gives:
		"s":
			return 2
		"B":
			return 4
	return 0


func _read_changed(
	answer: WorkshopAnswer, changed: Variant, result: Variant, before: PackedFloat64Array
) -> void:
	answer.numbers = _numbers_of_vectors([changed])
	var untouched := answer.numbers == before.slice(0, answer.numbers.size())
	if untouched and _is_vector(result) and not is_same(result, changed):
		answer.kind = WorkshopAnswer.Kind.COPY
		answer.numbers = _numbers_of_vectors([result])


func _read_result(answer: WorkshopAnswer, result: Variant) -> void:
	if result == null:
		answer.kind = WorkshopAnswer.Kind.NOTHING
	elif _task.gives == "v" and _is_vector(result):
		answer.numbers = _numbers_of_vectors([result])
	elif _task.gives == "f" and (WorkshopAny.is_number(result)):
		answer.numbers = [WorkshopAny.number(result)]
	elif _task.gives == "b" and result is bool:
		answer.numbers = [1.0 if is_same(result, true) else 0.0]
	else:
		answer.kind = WorkshopAnswer.Kind.WRONG_KIND
		answer.came_back = type_string(typeof(result))


func _is_vector(thing: Variant) -> bool:
	return thing is Object and WorkshopAny.object(thing).get_script() == _vector


func _numbers_of_vectors(things: Array) -> PackedFloat64Array:
	var numbers: PackedFloat64Array = []
	for thing: Variant in things:
		if thing is Array:
			var lines: Array = thing
			for line: Object in lines:
				numbers.append_array(_numbers_of_vectors([line.get("start"), line.get("end")]))
		elif _is_vector(thing):
			numbers.append_array(_components(WorkshopAny.object(thing)))
		elif thing is Object:
			var ball: Object = thing
			numbers.append_array(_numbers_of_vectors([ball.get("position"), ball.get("velocity")]))
	return numbers


# NaN where a component is no number any more.
static func _components(vector: Object) -> PackedFloat64Array:
	var numbers: PackedFloat64Array = []
	for component: Variant in [vector.get("x"), vector.get("y")]:
		numbers.append(WorkshopAny.number(component) if WorkshopAny.is_number(component) else NAN)
	return numbers


func _energy_after(probe: WorkshopProbe) -> WorkshopAnswer:
	var inputs := inputs_of(probe.numbers)
	var ball: Object = inputs[0]
	var before := _energy_of(ball)
	for i in probe.repeats:
		call_with(inputs)
	var answer := WorkshopAnswer.new()
	answer.numbers = [_energy_of(ball) / before]
	return answer


# Of a ball of mass 1: motion and height.
func _energy_of(ball: Object) -> float:
	var position := _numbers_of_vectors([ball.get("position")])
	var velocity := _numbers_of_vectors([ball.get("velocity")])
	var pull := _numbers_of_vectors([ball.get("acceleration")])
	if position.size() + velocity.size() + pull.size() != 6:
		return NAN
	var motion := (velocity[0] * velocity[0] + velocity[1] * velocity[1]) / 2.0
	return motion - pull[0] * position[0] - pull[1] * position[1]
