class_name WorkshopExercise
extends RefCounted
## One exercise of the workshop: one or two methods, and the lesson where it belongs.

## Its number, 0 to 15; 12 are the student's own tests.
var number: int
## A few words, translated.
var title: String
## The id of the lesson in which it is shown; "" for none.
var lesson: String
## The methods to write, in their order.
var tasks: Array[WorkshopTask] = []


## An exercise without methods yet.
func _init(its_number: int, its_title: String, its_lesson: String) -> void:
	number = its_number
	title = its_title
	lesson = its_lesson


## The method with this name, null where the exercise has none.
func task(method: String) -> WorkshopTask:
	for found in tasks:
		if found.method == method:
			return found
	return null


## The class that holds its methods, such as `MyVec2`; "" for the tests.
func home() -> String:
	return tasks[0].home if tasks else ""
