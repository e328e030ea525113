class_name EngineCases
extends RefCounted
## The engine's own methods for the problems of the report.


## New cases for the problem with this id. Their nodes become children of [param host], which must
## be in the tree; [method MeasuredCase.finish] frees them.
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
