class_name Refusal
extends RefCounted
## A method that refuses what it was given returns one sentence, and "" when all went well. A caller
## who cannot be refused, because what it hands over has been checked or is a constant, passes the
## answer on to [method push]: so a refusal is never lost.


## Reports [param problem] as an error, where there is one; "" reports nothing.
static func push(problem: String) -> void:
	if problem:
		push_error("Refused: " + problem)
