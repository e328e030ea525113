class_name StabilityResult
extends RefCounted
## What became of a [StabilityCase].

## What was measured, in words and with its unit; or the sentence with which the world refused to go
## on.
var figure: String
## Whether the criterion holds.
var passed: bool


## A result with this figure.
func _init(with_figure: String, has_passed: bool) -> void:
	figure = with_figure
	passed = has_passed
