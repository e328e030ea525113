class_name WorkshopLines
extends RefCounted
## Some lines of a file in a row.

## The first one, from 0.
var first := 0
## The one behind the last.
var behind := 0
## The exercise whose text it is.
var exercise := -1
## The file in which they are.
var file := ""


## Where a function is in [param lines], with the comment above it; no lines where it is not there.
static func of_function(function: String, lines: PackedStringArray) -> WorkshopLines:
	var place := WorkshopLines.new()
	var head := RegEx.create_from_string(r"^(static[ \t]+)?func[ \t]+%s\b" % function)
	for at in lines.size():
		if head.search(lines[at]):
			place.first = at
			while place.first > 0 and lines[place.first - 1].begins_with("#"):
				place.first -= 1
			place.behind = at + 1
			while place.behind < lines.size() and _goes_on(lines[place.behind]):
				place.behind += 1
			while not lines[place.behind - 1].strip_edges():
				place.behind -= 1
			return place
	return place


# A bracket that closes the parameters stands at the edge, too.
static func _goes_on(line: String) -> bool:
	return not line.strip_edges() or line[0] in ["\t", " ", ")"]
