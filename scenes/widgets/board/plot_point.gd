class_name PlotPoint
extends RefCounted
## One point of a [LogPlot].

## Where it lies to the right, above 0.
var x: float
## How high it lies: 0 or more, or infinite where there is no answer.
var y: float
## To which series it belongs, counted from 0; see [method LogPlot.show_series].
var series: int
## What it is, in words, translated: a line each.
var words: PackedStringArray


## A point with all that a plot shows of it.
func _init(its_x: float, its_y: float, its_series: int, its_words: PackedStringArray) -> void:
	x = its_x
	y = its_y
	series = its_series
	words = its_words
