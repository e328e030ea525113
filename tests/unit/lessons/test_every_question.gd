extends LabTest
## Of each question of each lesson, every wrong answer tells which mistake led to it, and the
## solution holds the right numbers.

const _QUESTIONS := 200
const _SOLUTIONS := 20
const _FOLDER := "res://scenes/lessons/"


func test_every_known_mistake_has_an_answer_of_its_own() -> void:
	for script: GDScript in _exercises():
		var kinds: Dictionary = script.get_script_constant_map()["Kind"]
		for kind: String in kinds:
			var name_of_kind := "%s %s" % [script.resource_path.get_file(), kind]
			var number: int = kinds[kind]
			assert_eq(_first_clash(Callable(script, &"fresh"), number), "", name_of_kind)


func test_every_solution_holds_the_right_numbers() -> void:
	for script: GDScript in _exercises():
		var kinds: Dictionary = script.get_script_constant_map()["Kind"]
		for kind: int in kinds.values():
			for exercise: Exercise in _some(script, kind):
				var solution := exercise.solution()
				for number in exercise.right_answer:
					assert_string_contains(solution, NumberText.short(number), exercise.prompt)


# Some of a kind with fresh numbers, and that of the lecture.
func _some(script: GDScript, kind: int) -> Array[Exercise]:
	var rng := RandomNumberGenerator.new()
	rng.seed = 5
	var found: Array[Exercise] = []
	for i in _SOLUTIONS:
		found.append(Exercise.drawn(Callable(script, &"fresh"), kind, rng))
	if script.has_method(&"of_the_lecture"):
		var of_the_lecture: Exercise = script.call(&"of_the_lecture", kind)
		if of_the_lecture:
			found.append(of_the_lecture)
	return found


# The first question of a kind in which two answers are the same.
func _first_clash(fresh: Callable, kind: int) -> String:
	var rng := RandomNumberGenerator.new()
	rng.seed = 5
	for i in _QUESTIONS:
		var exercise := Exercise.drawn(fresh, kind, rng)
		if not exercise.tells_mistakes_apart():
			var answers := exercise.mistakes.map(
				func(mistake: Exercise.Mistake) -> String: return Exercise.text_of(mistake.answer)
			)
			return (
				"%s Right: %s, mistakes: %s"
				% [exercise.prompt, Exercise.text_of(exercise.right_answer), ", ".join(answers)]
			)
	return ""


func _exercises() -> Array[GDScript]:
	var found: Array[GDScript] = []
	for lesson in DirAccess.get_directories_at(_FOLDER):
		for file in DirAccess.get_files_at(_FOLDER.path_join(lesson)):
			if file.ends_with("_exercise.gd"):
				found.append(load(_FOLDER.path_join(lesson).path_join(file)) as GDScript)
	return found
