extends RefCounted
## A source file with one mistake in it.

## The file, such as scripts/vec2.gd.
var file: String

## What was changed, in one line.
var title: String

## The first changed line, counted from 1.
var line: int

## The whole file with the mistake.
var code: String


func _init(of_file: String, with_title: String, at_line: int, with_code: String) -> void:
	file = of_file
	title = with_title
	line = at_line
	code = with_code


## Whether Godot compiles it. The process must not use any object of the file's class; afterwards
## the class is as it was.
func compiles() -> bool:
	var script: GDScript = load("res://" + file)
	var right_code := script.source_code
	script.source_code = code
	var error := script.reload()
	script.source_code = right_code
	script.reload()
	return error == OK
