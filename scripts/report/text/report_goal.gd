class_name ReportGoal
extends RefCounted
## A goal of the report, and whether the measurements reach it.

## What the goal is about.
var what := ""
## The bound, as text.
var wanted := ""
## What was measured, as text.
var measured := "not measured in this run"
## Whether this run has measured what the goal needs.
var is_judged := false
## Whether the goal is reached; it has a meaning only if [member is_judged].
var is_reached := false


## A goal that is not judged yet.
func _init(what_is_asked: String, wanted_text: String) -> void:
	what = what_is_asked
	wanted = wanted_text


## Judges by a number that must be at least [param bound]; NaN means not measured.
func at_least(value: float, bound: float) -> ReportGoal:
	return _judge(value, value >= bound)


## Judges by a number that must be at most [param bound]; NaN means not measured.
func at_most(value: float, bound: float) -> ReportGoal:
	return _judge(value, value <= bound)


## The verdict for the table.
func verdict() -> String:
	if not is_judged:
		return "-"
	return "reached" if is_reached else "**not reached**"


func _judge(value: float, reached: bool) -> ReportGoal:
	if is_nan(value):
		return self
	is_judged = true
	is_reached = reached
	measured = FigureText.short(value) if is_finite(value) else "no answer"
	return self
