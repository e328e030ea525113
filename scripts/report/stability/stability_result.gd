class_name StabilityResult
extends RefCounted
## The result of a [StabilityCase].

## What was measured, in words and with its unit; or the sentence with which a world refused.
var figure: String
## Whether the criterion holds.
var passed: bool


## A result with this figure.
func _init(with_figure: String, has_passed: bool) -> void:
	figure = with_figure
	passed = has_passed
