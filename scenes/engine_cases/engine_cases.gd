class_name EngineCases
extends RefCounted
## The engine's own methods, for each problem of the report that it can be set to.


## Fresh cases for the problem with that id. What they need of the engine becomes a child of
## [param host], which has to be in the tree, and is freed by [method MeasuredCase.finish].
static func of(problem_id: String, is_quick: bool, host: Node) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	match problem_id:
		"scalar_projection":
			for situation in ProjectionPairs.SITUATIONS:
				found.append(Vector2Projection.new(situation, is_quick))
		"ball_in_box":
			found = EngineShotCases.in_box(is_quick, host)
		"angled_lines":
			found = EngineShotCases.among_lines(is_quick, host)
		"many_segments":
			found = EngineShotCases.among_many(host)
		"dropped_ball":
			for bounciness in DroppedBall.BOUNCINESSES:
				for rate: int in [60] if is_quick else [60, 240]:
					found.append(RigidDrop.new(host, bounciness, rate))
		"many_balls":
			for crowd in ManyBallsProblem.crowds(is_quick):
				for rate: int in [60, 240]:
					found.append(RigidCrowd.new(host, crowd, rate))
		"digits_of_pi":
			for n in DigitsOfPiProblem.numbers(is_quick):
				for rate: int in [60, 960] if is_quick or n > 2 else [60, 960, 3840]:
					found.append(RigidPi.new(host, n, rate))
	return found
