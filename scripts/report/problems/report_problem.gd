@abstract class_name ReportProblem
extends RefCounted
## A problem that several methods solve: what is asked, and which methods are measured.
##
## [method cases] lists the lab's own methods. Those of the engine are in `scenes/engine_cases/`,
## because nothing in `scripts/` may use nodes or physics.

## Its name in files and tables, such as ball_in_box.
var id := ""
## Its title for readers.
var title := ""
## What is asked of the methods, and what their error is: one or two sentences.
var question := ""
## The method that the baselines are compared with; "" for the most exact of the lab's own.
var champion := ""
## The title of the horizontal axis of the picture.
var run_time_axis := "run time, µs per simulated second"
## The title of the vertical axis of the picture.
var error_axis := "error, px"

## New cases, none of them run yet. The quick form has fewer of them, and each run takes at most
## about 50 ms.
@abstract func cases(is_quick: bool) -> Array[MeasuredCase]


## Cases for the report alone, which solve nothing: what is measured with them shows how good a
## method can be at best. None by default.
func ceilings() -> Array[MeasuredCase]:
	return []


## A further section of the report about these measurements, in Markdown; "" for none.
func remarks(_rows: Array[Measurement]) -> String:
	return ""
