class_name ScalarProjectionProblem
extends ReportProblem
## The first problem: the scalar projection of one vector on another, by angles and by the dot
## product.


func _init() -> void:
	id = "scalar_projection"
	title = "The scalar projection of one vector on another"
	question = (
		(
			"a . b / |b| for %d pairs of vectors, one call each. The error is the largest one,"
			% ProjectionPairs.COUNT
		)
		+ " as a fraction of the length of a, against 106 bits."
	)
	run_time_axis = "run time, µs per call"
	error_axis = "worst error / |a|"


## See [method ReportProblem.cases].
func cases(is_quick: bool) -> Array[MeasuredCase]:
	var found: Array[MeasuredCase] = []
	for situation in ProjectionPairs.SITUATIONS:
		found.append(ProjectionByAngles.new(situation, is_quick))
		found.append(ProjectionByDotProduct.new(situation, is_quick))
	return found
