extends LabTest
## Properties of 2000 fresh questions of each kind, all from one seed.

const _COUNT := 2000
const _SEED := 20261123

var _exercises: Dictionary[ProjectionExercise.Kind, Array] = {}


func before_all() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = _SEED
	for kind: ProjectionExercise.Kind in ProjectionExercise.Kind.values():
		_exercises[kind] = []
		for i: int in _COUNT:
			_exercises[kind].append(Exercise.drawn(ProjectionExercise.fresh, kind, rng))


func test_the_right_answer_is_that_of_school_geometry() -> void:
	var errors: PackedFloat64Array = []
	for kind: ProjectionExercise.Kind in _exercises:
		for exercise: ProjectionExercise in _exercises[kind]:
			var wanted := _answer(kind, exercise.a, exercise.b)
			for i: int in wanted.size():
				errors.append(absf(exercise.right_answer[i] - wanted[i]))
	assert_all_at_most(errors, 1e-12)


func test_right_answers_have_two_decimals_at_most() -> void:
	var leftovers: PackedFloat64Array = []
	for exercise: ProjectionExercise in _all():
		for number: float in exercise.right_answer:
			leftovers.append(absf(number * 100.0 - roundf(number * 100.0)))
	assert_all_at_most(leftovers, 1e-9)


func test_the_components_are_whole_and_none_is_zero() -> void:
	# By angles a length and two angles are given, and no components.
	for exercise: ProjectionExercise in _all():
		if exercise in _exercises[ProjectionExercise.Kind.PRIMITIVE]:
			break
		for number: float in [exercise.a.x, exercise.a.y, exercise.b.x, exercise.b.y]:
			if number == 0.0 or number != roundf(number):
				fail_test("%s in %s" % [number, exercise.prompt])
				return
	pass_test("all components are whole")


func test_no_known_mistake_leads_to_the_right_answer_or_to_that_of_another() -> void:
	for exercise: ProjectionExercise in _all():
		for mistake: Exercise.Mistake in exercise.mistakes:
			var verdict := exercise.check(mistake.answer)
			if verdict.is_right or verdict.sentence != mistake.sentence:
				fail_test("%s: %s" % [exercise.prompt, mistake.sentence])
				return
	pass_test("all mistakes are told apart")


func test_a_mistake_rounded_to_two_decimals_is_still_named() -> void:
	for exercise: ProjectionExercise in _all():
		for mistake: Exercise.Mistake in exercise.mistakes:
			var typed := Array(mistake.answer).map(
				func(number: float) -> float: return roundf(number * 100.0) / 100.0
			)
			if exercise.check(PackedFloat64Array(typed)).is_right:
				fail_test("%s: %s" % [exercise.prompt, mistake.sentence])
				return
	pass_test("no rounded mistake is called right")


func test_all_four_quadrants_and_both_signs_of_the_answer_come_up() -> void:
	var seen := {}
	for exercise: ProjectionExercise in _exercises[ProjectionExercise.Kind.SCALAR]:
		seen[[signf(exercise.a.x), signf(exercise.a.y)]] = true
		seen[[signf(exercise.b.x), signf(exercise.b.y), "b"]] = true
		seen[signf(exercise.right_answer[0])] = true
	assert_eq(seen.size(), 10)


func _answer(kind: ProjectionExercise.Kind, a: Vec2, b: Vec2) -> PackedFloat64Array:
	var dot := a.x * b.x + a.y * b.y
	var square := b.x * b.x + b.y * b.y
	match kind:
		ProjectionExercise.Kind.DOT:
			return [dot]
		ProjectionExercise.Kind.SCALAR, ProjectionExercise.Kind.PRIMITIVE:
			return [dot / sqrt(square)]
	return [b.x * dot / square, b.y * dot / square]


func _all() -> Array:
	var found := []
	for kind: ProjectionExercise.Kind in _exercises:
		found.append_array(_exercises[kind])
	return found
