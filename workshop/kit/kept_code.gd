class_name WorkshopKeptCode
extends RefCounted
## What the student writes in the lab itself, where there is no editor: a text for each exercise,
## which holds its methods. It is kept for the next time, as his choices are.

const _KEY := "code_%d"
const _CHOSEN := "code_exercise"


## The exercises that can be written here, in their order: all that have methods.
static func exercises() -> Array[WorkshopExercise]:
	return WorkshopIndex.exercises().filter(
		func(exercise: WorkshopExercise) -> bool: return not exercise.tasks.is_empty()
	)


## The text of an exercise: what he has written, else its stub.
static func text_of(exercise: WorkshopExercise) -> String:
	var key := _KEY % exercise.number
	var of_browser := WebPage.kept(key)
	return of_browser if of_browser else str(KeptChoices.value(key, stub_of(exercise)))


## Keeps a text from now on.
static func keep(exercise: WorkshopExercise, text: String) -> void:
	var key := _KEY % exercise.number
	var is_stub := text == stub_of(exercise)
	WebPage.keep(key, "" if is_stub else text)
	if is_stub:
		KeptChoices.forget(key)
	else:
		KeptChoices.keep(key, text)


## The exercise at which he was last; the first that counts where he was at none.
static func chosen() -> WorkshopExercise:
	var of_browser := WebPage.kept(_CHOSEN)
	var number: int = KeptChoices.value(_CHOSEN, exercises()[1].number)
	return WorkshopIndex.exercise(of_browser.to_int() if of_browser else number)


## He is at another exercise from now on.
static func choose(exercise: WorkshopExercise) -> void:
	WebPage.keep(_CHOSEN, str(exercise.number))
	KeptChoices.keep(_CHOSEN, exercise.number)


## Whether something other than the stub is there.
static func is_written(exercise: WorkshopExercise) -> bool:
	return text_of(exercise) != stub_of(exercise)


## The methods of an exercise as they are in the starter, with what is said of them there.
static func stub_of(exercise: WorkshopExercise) -> String:
	var lines := WorkshopFiles.starter(WorkshopFiles.file_of(exercise.home())).split("\n")
	var stubs: PackedStringArray = []
	for task in exercise.tasks:
		var place := WorkshopLines.of_function(task.method, lines)
		stubs.append("\n".join(lines.slice(place.first, place.behind)))
	return "\n\n\n".join(stubs) + "\n"
