extends LabTest
## The first problem: what its cases measure, and that the hard vectors are hard.


func test_both_ways_are_right_to_a_few_bits_in_every_situation() -> void:
	for case in ScalarProjectionProblem.new().cases(true):
		case.run_once()
		assert_between(case.error, 1e-17, 20.0 * EPSILON, case.method + ", " + case.situation)


func test_run_times_are_finite_and_not_negative() -> void:
	for case in ScalarProjectionProblem.new().cases(true):
		case.run_once()
		assert_true(is_finite(case.result().run_time_us))
		assert_gte(case.result().run_time_us, 0.0)


func test_the_vectors_are_the_same_every_time() -> void:
	for situation in ProjectionPairs.SITUATIONS:
		var once := ProjectionPairs.of(situation)
		var again := ProjectionPairs.of(situation)
		assert_eq(once.map(all_digits), again.map(all_digits))


func test_nearly_perpendicular_ones_are() -> void:
	var vectors := ProjectionPairs.of(ProjectionPairs.PERPENDICULAR)
	for pair in range(0, vectors.size(), 2):
		var cosine := vectors[pair].normalized().dot(vectors[pair + 1].normalized())
		assert_lt(absf(cosine), 1e-6)


func test_lengths_reach_from_tiny_to_huge() -> void:
	var vectors := ProjectionPairs.of(ProjectionPairs.LONG_AND_SHORT)
	var lengths: PackedFloat64Array = []
	for vector in vectors:
		lengths.append(vector.length())
	lengths.sort()
	assert_lt(lengths[0], 1e-25)
	assert_gt(lengths[-1], 1e25)
