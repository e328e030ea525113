extends Lesson
## A lesson for tests that cannot start.


func start() -> void:
	var nothing := 0
	print(1 % nothing)
