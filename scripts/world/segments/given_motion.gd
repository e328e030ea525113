@abstract class_name GivenMotion
extends RefCounted
## A motion that a segment of an [EventWorld] can be given. The world knows no more of it than this,
## so that a program whose segments rest needs nothing of scripts/world/motion/, where
## [SegmentMotion] is.

## "" if this motion can be used; otherwise one sentence with the value and what is allowed. All its
## numbers must be within -[param largest]..[param largest].
@abstract func problem(largest: float) -> String

## Begins the motion of the segment at that place, at this time of the world in seconds, as the sum
## of two numbers. Gives the segments among which this one moves from now on.
@abstract func begin(segments: SegmentScan, place: int, time: float, low: float) -> SegmentScan
