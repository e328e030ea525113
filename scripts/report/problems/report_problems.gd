class_name ReportProblems
extends RefCounted
## The problems of the report, in order: those that a lesson measures live, and those of aiming.


## New objects for all problems.
static func all() -> Array[ReportProblem]:
	var found := LiveProblems.all()
	(
		found
		. append_array(
			[
				LeadShotProblem.new(),
				BallisticShotProblem.new(),
				BankShotProblem.new(),
				TimedShotProblem.new(),
			]
		)
	)
	return found
