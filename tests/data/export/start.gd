extends RefCounted
# Axis names no class, and EventWorld is in a comment only.
"""EventWorld in a text that is no comment, and neither needed."""

const Beside := preload("beside.gd")

var place := "res://tests/data/export/board.tscn"
var title := "Ball # no comment"
var info := LessonInfo.new()
var path := ^"%Plot"
