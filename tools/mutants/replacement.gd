extends RefCounted
## A mistake that is written down: lines of a file, and the lines that come in their place.

const Mutant := preload("mutant.gd")

## The file, such as scripts/vec2.gd.
var file: String

## What the change is, or why it is in its list.
var title: String

## The lines that go, each with its end of line. Together they must occur once in the file.
var old_text: String

## The lines that come; "" if the old ones are only left out.
var new_text: String


func _init(of_file: String, with_title: String) -> void:
	file = of_file
	title = with_title


## "" if the old lines occur exactly once in [param code]; else one sentence.
func problem(code: String) -> String:
	var times := _places(code).size()
	if times == 1 and old_text != new_text:
		return ""
	return "%s: %s: these lines must be there once and change:\n%s" % [file, title, old_text]


## The mutant of a file with this [param code], which must have no [method problem].
func mutant(code: String) -> Mutant:
	var place := _places(code)[0]
	var changed := code.substr(0, place) + new_text + code.substr(place + old_text.length())
	return Mutant.new(file, title, code.count("\n", 0, place) + 1, changed)


## Where the old lines begin in the code: whole lines only.
func _places(code: String) -> PackedInt32Array:
	var places := PackedInt32Array()
	var place := code.find(old_text)
	while place >= 0 and old_text != "":
		if place == 0 or code[place - 1] == "\n":
			places.append(place)
		place = code.find(old_text, place + 1)
	return places
