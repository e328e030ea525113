class_name ReportProblems
extends RefCounted
## The problems of the report, in order.


## New objects for all problems.
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
