extends LabTest
## Of each question of each lesson, every wrong answer tells which mistake led to it.

const _QUESTIONS := 200
const _FOLDER := "res://scenes/lessons/"


func test_every_known_mistake_has_an_answer_of_its_own() -> void:
	for script: GDScript in _exercises():
		var kinds: Dictionary = script.get_script_constant_map()["Kind"]
		for kind: String in kinds:
			var name_of_kind := "%s %s" % [script.resource_path.get_file(), kind]
			var number: int = kinds[kind]
			assert_eq(_first_clash(Callable(script, &"fresh"), number), "", name_of_kind)


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
