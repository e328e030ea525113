class_name WorkshopShape
extends RefCounted
## The shape of what a student has written, as a checksum: blanks, comments, the order of the
## methods and how things are called do not count, nor what is as in the starters. Two hand-ins with
## the same sum hold the same code.

## How many tokens it has: little code may be the same by chance.
var tokens := 0
## The checksum.
var sum := ""


## The shape of all methods in these files, by their names.
func _init(codes: Dictionary[String, WorkshopCode]) -> void:
	var of_starters: Dictionary[String, bool] = {}
	for file in WorkshopFiles.starters():
		for shape in _shapes_in(WorkshopCode.new(WorkshopFiles.starter(file).to_utf8_buffer())):
			of_starters[shape] = true
	var own: PackedStringArray = []
	for file in codes:
		for shape in _shapes_in(codes[file]):
			if not of_starters.has(shape):
				own.append(shape)
				tokens += shape.count(" ") + 1
	own.sort()
	sum = "\n".join(own).md5_text()


# Each method, its parameters before its body. What somebody may call otherwise is a number there:
# the first such name is 0, the second 1, and so on. The methods of the exercises have their names.
static func _shapes_in(code: WorkshopCode) -> PackedStringArray:
	var declared := WorkshopAllowed.declared_in(code.tokens())
	for task in WorkshopIndex.tasks():
		declared.erase(task.method)
	var shapes: PackedStringArray = []
	for function in code.functions():
		var names: PackedStringArray = []
		var shape: PackedStringArray = []
		for token in code.parameters_of(function) + code.body_of(function):
			if declared.has(token.text) and not token.text in names:
				names.append(token.text)
			shape.append(str(names.find(token.text)) if declared.has(token.text) else token.text)
		shapes.append(" ".join(shape))
	return shapes
