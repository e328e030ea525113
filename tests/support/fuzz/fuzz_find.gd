class_name FuzzFind
extends RefCounted
## A world in which something does not hold, as an issue tells it.

## Its kind.
var kind: FuzzKind
## Its number, before it was made small.
var number: int
## The world, made small.
var world: FuzzWorld
## What does not hold in it.
var problem: String


func _init(of_kind: FuzzKind, with_number: int, small_world: FuzzWorld) -> void:
	kind = of_kind
	number = with_number
	world = small_world
	problem = kind.problem_of(world)


## In Markdown: the problem as a heading, how to build the world again, the link that shows it.
func text() -> String:
	var link := world.link(kind.method)
	var parts: PackedStringArray = [
		"## %s %d: %s" % [kind.name, number, problem], "", "```", world.text(), "```"
	]
	if link:
		parts.append_array(["", "`%s`" % link])
	return "\n".join(parts) + "\n"
