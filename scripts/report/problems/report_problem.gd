@abstract class_name ReportProblem
extends RefCounted
## A problem that several methods solve: what is asked, and who can be measured at it.
##
## [method cases] lists the lab's own methods. Those of the engine are in `scenes/engine_cases/`,
## because nothing below `scripts/` may use nodes or physics.

## A word for files and tables, such as ball_in_box.
var id := ""
## One line for people.
var title := ""
## What is asked of the methods, and what their error is: one or two sentences.
var question := ""
## The method that the baselines are compared with; "" for the most exact of the lab's own.
var champion := ""
## The horizontal axis of the picture.
var run_time_axis := "run time, µs per simulated second"
## The vertical axis of the picture.
var error_axis := "error, px"

## Fresh cases, none of them run yet. The quick form has fewer, and each run takes at most about
## 50 ms.
@abstract func cases(is_quick: bool) -> Array[MeasuredCase]


## What else the report says of these measurements of it, in Markdown; "" for nothing.
func remarks(_rows: Array[Measurement]) -> String:
	return ""
