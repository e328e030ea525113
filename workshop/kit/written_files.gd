class_name WorkshopWrittenFiles
extends RefCounted
## The student's files, made of the texts that he has written in the lab itself: each is a starter,
## in which a text stands in place of the methods that it declares.

## The files by their names.
var files: Dictionary[String, PackedByteArray] = {}

# Where the texts are.
var _places: Array[WorkshopLines] = []


## Puts the files together, without the texts of the exercises in [param left_out].
func _init(left_out: PackedInt32Array) -> void:
	for file: String in WorkshopFiles.CLASSES:
		var written: Array[WorkshopExercise] = []
		for exercise in WorkshopKeptCode.exercises():
			var is_here := WorkshopFiles.file_of(exercise.home()) == file
			if is_here and WorkshopKeptCode.is_written(exercise):
				if not exercise.number in left_out:
					written.append(exercise)
		_put_together(file, written)


## The exercise whose text has a line of a file, both counted from 1; -1 for none.
func exercise_at(file: String, line: int) -> int:
	for place in _places:
		if place.file == file and line > place.first and line <= place.behind:
			return place.exercise
	return -1


## The exercise whose text is the last one in a file; -1 for none.
func last_exercise_in(file: String) -> int:
	var last := -1
	for place in _places:
		if place.file == file:
			last = place.exercise
	return last


## The line in the text of [param exercise] for a line of its file, from 1; 0 where that is not in
## the text.
func line_in_text(exercise: int, file: String, line: int) -> int:
	if exercise_at(file, line) != exercise:
		return 0
	var own := _places.filter(func(place: WorkshopLines) -> bool: return place.exercise == exercise)
	return line - own[0].first


func _put_together(file: String, written: Array[WorkshopExercise]) -> void:
	var lines := WorkshopFiles.starter(file).split("\n")
	var texts: Array[PackedStringArray] = []
	for exercise in written:
		var code := WorkshopCode.new(WorkshopKeptCode.text_of(exercise).to_utf8_buffer())
		texts.append(_with_tabs(code.text).split("\n"))
		var methods := exercise.tasks.map(func(task: WorkshopTask) -> String: return task.method)
		# A method that the text has under another name is not there.
		for function: String in Array(code.functions()) + methods:
			var place := WorkshopLines.of_function(function, lines)
			for line in place.behind - place.first:
				lines.remove_at(place.first)
	for at in texts.size():
		var place := WorkshopLines.new()
		place.file = file
		place.exercise = written[at].number
		place.first = lines.size()
		lines.append_array(texts[at])
		place.behind = lines.size()
		_places.append(place)
	files[file] = "\n".join(lines).to_utf8_buffer()


# As the starters are indented; where both are mixed it stays, and is told.
static func _with_tabs(text: String) -> String:
	if WorkshopSentences.line_with_mixed_indent(text) > 0:
		return text
	return WorkshopTogether.with_tabs(text)
