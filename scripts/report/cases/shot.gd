@abstract class_name Shot
extends RefCounted
## One elastic ball flown among segments without gravity: what every method is given, and how its
## answer is judged.

## See [member Measurement.problem].
var problem := ""
## See [member Measurement.situation].
var situation := ""
## The ball at its start; to be copied.
var ball: Ball
## How long a measured flight is.
var seconds := 10.0
## Whether each run goes on where the last one has ended, because setting up takes long.
var goes_on := false
## For so many seconds [method judge] wants to see the path, frame by frame; 0 if the end is enough.
var path_seconds := 0.0

## What it bounces off; made when it is first asked for.
@abstract func segments() -> Array[LineSegment]

## Sets error, note and figures of [param case] by where the ball is at the end, in pixels, and by
## [param path]: x, y after each 60th of a second.
@abstract func judge(case: MeasuredCase, end: Vec2, path: PackedFloat64Array) -> void
