class_name WorkshopChameleon
extends RefCounted
## Stands in for a student's classes while his tests run: it answers right, or in one wrong way.

# Far enough from every right answer.
const _OFF := 1000.0

## The method that is wrong now; "" for none.
static var wrong_method := ""
## The way in which it is wrong; null: it is off by far, so that every test of it must go red.
static var wrong_way: WorkshopWay = null


## The text of one of the student's classes whose methods all answer by [method play].
static func text_of(of_class: String) -> String:
	var lines := WorkshopFiles.starter(WorkshopFiles.file_of(of_class)).split("\n")
	for task in WorkshopIndex.tasks():
		if task.home == of_class:
			_replace_body(lines, task)
	return "\n".join(lines)


## Answers to a call of [param method] by the object [param receiver] of the class [param vector];
## [param receiver] is null for a static method.
static func play(method: String, receiver: Object, arguments: Array) -> Variant:
	var task := WorkshopIndex.task(method)
	var inputs := arguments.duplicate()
	if receiver:
		inputs.push_front(receiver)
	var numbers := _numbers_of(inputs)
	var answer := _answer(task, numbers)
	if wrong_method == method and wrong_way and wrong_way.spoils_inputs:
		_spoil(inputs, 1 if task.is_in_place() else 0)
	match task.gives:
		"s":
			_set_vector(WorkshopAny.object(inputs[0]), answer[0], answer[1])
		"B":
			_set_ball(WorkshopAny.object(inputs[0]), answer)
		"f":
			return answer[0]
		"b":
			return answer[0] != 0.0
		"v":
			return _vector_like(WorkshopAny.object(inputs[0]), answer)
	return null


static func _answer(task: WorkshopTask, numbers: PackedFloat64Array) -> PackedFloat64Array:
	var right := WorkshopCall.of_lab(task).run(numbers).numbers
	if wrong_method != task.method or (wrong_way and wrong_way.spoils_inputs):
		return right
	if wrong_way:
		return wrong_way.answer.call(numbers)
	if task.gives == "b":
		return [1.0 - right[0]]
	for index in right.size():
		right[index] = right[index] + _OFF if is_finite(right[index]) else _OFF
	return right


# The last line of a starter's method is all of its body.
static func _replace_body(lines: PackedStringArray, task: WorkshopTask) -> void:
	var head := RegEx.create_from_string(r"^(?:static )?func %s\(" % task.method)
	for index in lines.size():
		if head.search(lines[index]):
			while not lines[index].ends_with(":"):
				index += 1
			lines[index + 1] = "\t" + _call_of(task, _parameters_at(lines, index))
			return


static func _parameters_at(lines: PackedStringArray, end: int) -> PackedStringArray:
	var begin := end
	while not lines[begin].contains("func "):
		begin -= 1
	var head := "".join(lines.slice(begin, end + 1))
	var names: PackedStringArray = []
	for hit in RegEx.create_from_string(r"[(,]\s*(\w+):").search_all(head):
		names.append(hit.get_string(1))
	return names


static func _call_of(task: WorkshopTask, parameters: PackedStringArray) -> String:
	var receiver := "self" if task.is_of_vector() else "null"
	var played := 'WorkshopChameleon.play("%s", %s, [%s])'
	played = played % [task.method, receiver, ", ".join(parameters)]
	return played if task.is_in_place() else "return " + played


static func _numbers_of(inputs: Array) -> PackedFloat64Array:
	var numbers: PackedFloat64Array = []
	for input: Variant in inputs:
		if input is Array:
			var lines: Array = input
			for line: Object in lines:
				numbers.append_array(_numbers_of([line.get("start"), line.get("end")]))
		elif WorkshopAny.is_number(input):
			numbers.append(WorkshopAny.number(input))
		elif input is Object:
			numbers.append_array(_numbers_of_object(WorkshopAny.object(input)))
	return numbers


static func _numbers_of_object(object: Object) -> PackedFloat64Array:
	if object.get("position") == null:
		return _numbers_of([object.get("x"), object.get("y")])
	var parts := ["position", "velocity", "radius", "acceleration"]
	return _numbers_of(parts.map(func(part: String) -> Variant: return object.get(part)))


# Changes the first vector that must stay as it is.
static func _spoil(inputs: Array, first: int) -> void:
	for input: Variant in inputs.slice(first):
		if input is Object:
			var vector: Object = input
			var x := WorkshopAny.number(vector.get("x"))
			var y := WorkshopAny.number(vector.get("y"))
			_set_vector(vector, x + 1.0, y + 1.0)
			return
		if input is Array:
			_spoil([WorkshopAny.object(WorkshopAny.list(input)[0]).get("start")], 0)
			return


static func _vector_like(model: Object, answer: PackedFloat64Array) -> Object:
	var script: GDScript = model.get_script()
	return script.callv(&"new", [answer[0], answer[1]])


static func _set_vector(vector: Object, x: float, y: float) -> void:
	vector.set("x", x)
	vector.set("y", y)


static func _set_ball(ball: Object, answer: PackedFloat64Array) -> void:
	_set_vector(WorkshopAny.object(ball.get("position")), answer[0], answer[1])
	_set_vector(WorkshopAny.object(ball.get("velocity")), answer[2], answer[3])
