class_name WorkshopIndex
extends RefCounted
## All exercises of the workshop in their order, which is that of the lecture; those of aiming come
## after the student's own tests.

## The number of the exercise in which the student writes tests of his own. It has no methods.
const TESTS := 12
## The number of the last exercise.
const LAST := 15

static var _made: Array[WorkshopExercise] = []
static var _language := ""


## All exercises, with their sentences in the language that is spoken now.
static func exercises() -> Array[WorkshopExercise]:
	if _made.is_empty() or _language != TranslationServer.get_locale():
		_language = TranslationServer.get_locale()
		_made = [
			WorkshopRotation.exercise(),
			WorkshopDirections.normalizing(),
			WorkshopDirections.normals(),
			WorkshopProducts.dot_product(),
			WorkshopProducts.projections(),
			WorkshopBallAndLine.distance(),
			WorkshopBallAndLine.touching(),
			WorkshopBallAndLine.reset(),
			WorkshopTimeOfImpact.exercise(),
			WorkshopReflection.exercise(),
			WorkshopManyLines.exercise(),
			WorkshopSegmentImpact.exercise(),
			WorkshopExercise.new(TESTS, LabText.translate("Your own tests"), ""),
			WorkshopLeadShot.exercise(),
			WorkshopBallisticShot.exercise(),
			WorkshopBankShot.exercise(),
		]
	return _made


## The exercise with a number.
static func exercise(number: int) -> WorkshopExercise:
	return exercises()[number]


## The exercises that belong to a lesson, in their order.
static func of_lesson(lesson: String) -> Array[WorkshopExercise]:
	return exercises().filter(
		func(listed: WorkshopExercise) -> bool: return listed.lesson == lesson
	)


## Every method of all exercises.
static func tasks() -> Array[WorkshopTask]:
	var found: Array[WorkshopTask] = []
	for listed in exercises():
		found.append_array(listed.tasks)
	return found


## The method with this name, null where there is none.
static func task(method: String) -> WorkshopTask:
	for found in tasks():
		if found.method == method:
			return found
	return null
