class_name LiveProblems
extends RefCounted
## The problems of the report that the lesson on error and time measures live, in order: what its
## demo holds depends on them.


## New objects for these problems.
static func all() -> Array[ReportProblem]:
	return [
		ScalarProjectionProblem.new(),
		BallInBoxProblem.new(),
		AngledLinesProblem.new(),
		ManySegmentsProblem.new(),
		DroppedBallProblem.new(),
		ManyBallsProblem.new(),
		DigitsOfPiProblem.new(),
	]
