extends RefCounted
## Reads a list of replacements. A line `file: title` begins one; of the lines below it, those
## marked `-` go and those marked `+` come. Empty lines and those marked `#` say nothing.

const Replacement := preload("replacement.gd")


## All replacements of the list at [param path], in its order.
static func read(path: String) -> Array[Replacement]:
	var replacements: Array[Replacement] = []
	for line: String in FileAccess.get_file_as_string(path).split("\n", false):
		if line.begins_with("-"):
			replacements[-1].old_text += line.substr(1) + "\n"
		elif line.begins_with("+"):
			replacements[-1].new_text += line.substr(1) + "\n"
		elif not line.begins_with("#"):
			var parts := line.split(": ", true, 1)
			replacements.append(Replacement.new(parts[0], parts[1]))
	return replacements
