@abstract class_name Shot
extends RefCounted
## One elastic ball among segments without gravity: what every method is given, and how its answer
## is judged.

## See [member Measurement.problem].
var problem := ""
## See [member Measurement.situation].
var situation := ""
## The ball at its start. Copy it before moving it.
var ball: Ball
## The simulated time of a measured flight, in seconds.
var seconds := 10.0
## Whether each run goes on from the end of the last run, because setting up takes long.
var goes_on := false
## The time in seconds for which [method judge] needs the path, frame by frame; 0 if the end is
## enough.
var path_seconds := 0.0

## The segments that the ball bounces off; made at the first call.
@abstract func segments() -> Array[LineSegment]

## Sets error, note and figures of [param case] from [param end], the ball's last position in
## pixels, and from [param path]: x, y after each 60th of a second.
@abstract func judge(case: MeasuredCase, end: Vec2, path: PackedFloat64Array) -> void
