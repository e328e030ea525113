extends LabTest
## The questions of the lesson on the dot product, for the lecture's numbers: 7 * 8 + 1 * (-6) = 50,
## |b| = 10.

const _DOT: Dictionary[float, String] = {
	-62.0: "The products are added, not subtracted: ax bx + ay by.",
	62.0: "The products are added, not subtracted: ax bx + ay by.",
	-34.0: "x goes with x, and y with y: ax bx + ay by.",
	5.0: "That is the scalar projection: a · b is not divided by |b|.",
}
const _SCALAR: Dictionary[float, String] = {
	50.0: "b was not normalized: that is |b| = 10 times too big.",
	0.5: "Divided by |b| twice: a · b / |b| is enough for the scalar.",
	7.07: "That is b on a: a · b\u0302 is not b · â.",
	-50.0: "The sign is wrong, and b was not normalized.",
	-5.0: "The sign is wrong: negative beyond 90°, positive below.",
}


func test_the_question_has_the_numbers_of_the_lecture() -> void:
	var exercise := _lecture(ProjectionExercise.Kind.DOT)
	assert_eq(exercise.prompt, "a = (7, 1), b = (8, −6). What is the dot product a · b?")
	assert_eq(exercise.answer_titles, PackedStringArray(["a · b ="]))


func test_the_right_answers_of_the_lecture() -> void:
	assert_true(_lecture(ProjectionExercise.Kind.DOT).check([50.0]).is_right)
	assert_true(_lecture(ProjectionExercise.Kind.SCALAR).check([5.0]).is_right)
	assert_true(_lecture(ProjectionExercise.Kind.VECTOR).check([4.0, -3.0]).is_right)


func test_the_solutions_of_the_lecture() -> void:
	var solutions: PackedStringArray = [
		"a · b = 7·8 + 1·(−6) = 50",
		"a · b\u0302 = a · b / |b| = 50 / 10 = 5",
		"p = (a · b\u0302) b\u0302 = 5 (0.8, −0.6) = (4, −3)",
		"|a| cos(α − β) = 7.071·cos 45° = 5",
	]
	for kind: ProjectionExercise.Kind in ProjectionExercise.Kind.values():
		assert_eq(ProjectionExercise.of_the_lecture(kind).solution(), solutions[kind])


func test_the_primitive_way_is_asked_by_length_and_angles() -> void:
	var exercise := ProjectionExercise.of_the_lecture(ProjectionExercise.Kind.PRIMITIVE)
	assert_string_contains(
		exercise.prompt, "|a| = 7.071, its angle is α = 8.13°, that of b is β = −36.87°"
	)
	assert_true(exercise.check([7.071 * cos(deg_to_rad(45.0))]).is_right)
	assert_eq(exercise.check([7.0]).sentence, "That is |a| cos α: take β off first.")
	assert_string_contains(exercise.check([0.7071]).sentence, "still has to be multiplied by |a|")


func test_each_known_mistake_of_the_dot_product_is_named() -> void:
	for answer: float in _DOT:
		var verdict := _lecture(ProjectionExercise.Kind.DOT).check([answer])
		assert_eq(verdict.sentence, _DOT[answer], str(answer))


func test_each_known_mistake_of_the_scalar_projection_is_named() -> void:
	for answer: float in _SCALAR:
		var verdict := _lecture(ProjectionExercise.Kind.SCALAR).check([answer])
		assert_eq(verdict.sentence, _SCALAR[answer], str(answer))


func test_the_length_of_a_and_the_distance_are_no_scalar_projection() -> void:
	var exercise := _exercise(ProjectionExercise.Kind.SCALAR, Vec2.new(2, 1), Vec2.new(3, 4))
	var length := "That is |a|: the shadow is shorter, unless both are parallel."
	var distance := "That is the distance from the line: the rest, not the shadow."
	assert_eq(exercise.check([2.236]).sentence, length)
	assert_eq(exercise.check([1.0]).sentence, distance)
	assert_eq(exercise.check([-1.0]).sentence, distance)


func test_the_determinant_and_the_wrong_sign_are_no_dot_product() -> void:
	var exercise := _exercise(ProjectionExercise.Kind.DOT, Vec2.new(2, 1), Vec2.new(3, 4))
	var determinant := "That is the determinant ax by − ay bx, not the dot product."
	var wrong_sign := "The sign is wrong: unlike signs make a product negative."
	assert_eq(exercise.check([5.0]).sentence, determinant)
	assert_string_contains(exercise.check([-5.0]).sentence, "determinant ay bx − ax by")
	assert_eq(exercise.check([-10.0]).sentence, wrong_sign)


func test_each_known_mistake_of_the_vector_projection_is_named() -> void:
	var sentences: Dictionary[PackedFloat64Array, String] = {
		PackedFloat64Array([400.0, -300.0]):
		"b was not normalized, in two places: that is |b|² = 100 times too big.",
		PackedFloat64Array([40.0, -30.0]): "b was not normalized: that is |b| = 10 times too big.",
		PackedFloat64Array([7.0, 1.0]): "That is b on a: p must be parallel to b.",
		PackedFloat64Array([3.0, 4.0]): "That is the rest a − p: it is perpendicular to b.",
		PackedFloat64Array([-3.0, -4.0]): "That is p − a: it is perpendicular to b.",
		PackedFloat64Array([-4.0, 3.0]): "p points the other way: mind the sign of a · b.",
	}
	for answer: PackedFloat64Array in sentences:
		var verdict := _lecture(ProjectionExercise.Kind.VECTOR).check(answer)
		assert_false(verdict.is_right)
		assert_eq(verdict.sentence, sentences[answer], str(answer))


func _lecture(kind: ProjectionExercise.Kind) -> ProjectionExercise:
	return _exercise(kind, Vec2.new(7, 1), Vec2.new(8, -6))


func _exercise(kind: ProjectionExercise.Kind, a: Vec2, b: Vec2) -> ProjectionExercise:
	return ProjectionExercise.new(kind, a, b)
