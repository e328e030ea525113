class_name ClassOrValueModel
extends LessonModel
## A Vec2 is an object that names share; Godot's Vector2 is a value that every name has for itself.
##
## A Vec2 and a Vector2 get the same numbers, each gets a second name, and both are then moved to
## the same place.

## Components lie within -LARGEST..LARGEST, so that those of the Vector2 stay finite.
const LARGEST := 1e38

## The Vec2 that the student moves.
var position := Vec2.new(2.0, -3.0)
## A second name: for the same Vec2, or with [member copies] for a copy.
var old := position
## The Vector2 that the student moves: the same numbers with 32 bits.
var value := Vector2(2.0, -3.0)
## A second name for the Vector2: always a copy.
var old_value := value
## Whether [method remember] takes a copy of the Vec2 instead of giving it a second name.
var copies := false

# Where the Vec2 was at the latest remember().
var _remembered := position.copy()


## What a student writes to keep the old place: `old = position`, with [member copies]
## `old = position.copy()`; for the Vector2 `old_value = value`.
func remember() -> void:
	old = position.copy() if copies else position
	old_value = value
	_remembered = position.copy()


## Moves Vec2 and Vector2 to the same place, by changing them.
func move_to(x: float, y: float) -> void:
	position.set_xy(x, y)
	value = Vector2(x, y)


## Where both were when the second names were given.
func first_place() -> Vec2:
	return _remembered.copy()


## Takes the number that has this name in the formula: `x` or `y` of both. "" if it could be taken;
## else one translated sentence, and nothing changes.
func enter(name_in_line: String, number: float) -> String:
	var problem := StateCheck.within(name_in_line, number, -LARGEST, LARGEST)
	if problem:
		return problem
	if name_in_line == "x":
		move_to(number, position.y)
	else:
		move_to(position.x, number)
	return ""


## Begins anew: what is remembered is [param old_place], then both are moved to [param place].
func remember_and_move(old_place: Vec2, place: Vec2) -> void:
	position = old_place.copy()
	value = old_place.to_vector2()
	remember()
	move_to(place.x, place.y)


## Whether [member position] and [member old] are two names for one Vec2.
func is_shared() -> bool:
	return old == position


## All of it, for undo and links.
func to_dictionary() -> Dictionary:
	return {
		"position": PackedFloat64Array([position.x, position.y]),
		"old": PackedFloat64Array([_remembered.x, _remembered.y]),
		"copies": copies,
	}


## "" if all components of [param stored] are within [constant LARGEST]; else a sentence with the
## first that is not.
func problem_in(stored: Dictionary) -> String:
	var problems: PackedStringArray = []
	for name: String in ["position", "old"]:
		var place: PackedFloat64Array = stored[name]
		for number in place:
			problems.append(StateCheck.within(name, number, -LARGEST, LARGEST))
	return StateCheck.first(problems)


## Puts back what [method to_dictionary] has told.
func from_dictionary(stored: Dictionary) -> void:
	var place: PackedFloat64Array = stored["position"]
	var old_place: PackedFloat64Array = stored["old"]
	copies = stored["copies"]
	remember_and_move(Vec2.new(old_place[0], old_place[1]), Vec2.new(place[0], place[1]))
