extends Lesson
## A lesson for tests: counts the seconds that its transport lets pass, or does nothing without
## one.

var seconds := 0.0


func start() -> void:
	if services.has(&"transport"):
		(services[&"transport"] as Transport).advanced.connect(_advance)


func state() -> Dictionary:
	return {"seconds": seconds}


func show_state(stored: Dictionary) -> void:
	seconds = stored["seconds"]


func _advance(passed: float) -> void:
	seconds += passed
