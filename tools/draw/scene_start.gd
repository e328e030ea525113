extends RefCounted
## What the parts of a lesson's scene show when the lesson starts, compared with what the scene's
## file says: the editor draws the file, and no lesson runs there.

# Only these change what is drawn.
const _WATCHED: PackedStringArray = ["BoardPart", "Handle", "DraggableVector", "VerdictCard"]


## One text for each difference between [param lesson], which has just started, and a fresh
## [param scene], the same as its file has it: `Board/A.head: (7, 1) in the lesson, (0, 0) in its
## scene`.
static func differences(lesson: Node, scene: Node) -> PackedStringArray:
	var found: PackedStringArray = []
	for node: Node in _parts(lesson):
		var path := lesson.get_path_to(node)
		var in_file := scene.get_node(path)
		for property: StringName in _properties(node):
			var now: Variant = node.get(property)
			var before: Variant = in_file.get(property)
			if now != before:
				found.append(
					"%s.%s: %s in the lesson, %s in its scene" % [path, property, now, before]
				)
	return found


## Gives the parts of [param scene] the values that they have in [param lesson].
static func copy(lesson: Node, scene: Node) -> void:
	for node: Node in _parts(lesson):
		var in_file := scene.get_node(lesson.get_path_to(node))
		for property: StringName in _properties(node):
			in_file.set(property, node.get(property))


# What is written in the lesson's own scene, not in a scene that it holds.
static func _parts(lesson: Node) -> Array[Node]:
	return lesson.find_children("*").filter(
		func(node: Node) -> bool: return node.owner == lesson and _is_watched(node)
	)


static func _is_watched(node: Node) -> bool:
	var script: Script = node.get_script()
	while script:
		if script.get_global_name() in _WATCHED:
			return true
		script = script.get_base_script()
	return false


static func _properties(node: Node) -> Array[StringName]:
	var found: Array[StringName] = [&"visible"]
	var wanted := PROPERTY_USAGE_SCRIPT_VARIABLE | PROPERTY_USAGE_STORAGE
	for property: Dictionary in node.get_property_list():
		var usage: int = property["usage"]
		var title: StringName = property["name"]
		if usage & wanted == wanted:
			found.append(title)
	return found
