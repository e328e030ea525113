extends Lesson
## A lesson for tests whose start cannot be shown.


## A model with an impossible number.
class ImpossibleModel:
	extends LessonModel

	func to_dictionary() -> Dictionary:
		return {"radius": -1.0}

	func from_dictionary(_stored: Dictionary) -> void:
		pass

	func problem_in(stored: Dictionary) -> String:
		return "The radius must not be %d." % stored["radius"]


func start() -> void:
	begin(ImpossibleModel.new(), func() -> void: pass)
