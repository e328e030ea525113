class_name Motion
extends RefCounted
## Whether things may move by themselves: as the student has chosen, else as the system or the
## browser asks for.

const _KEY := "motion"


## True where nothing should move unless the student makes it move.
static func is_reduced() -> bool:
	var choice: String = KeptChoices.value(_KEY, "")
	if choice:
		return choice == "reduced"
	# The engine says 1, or it does not know: then a browser may.
	var wish := DisplayServer.accessibility_should_reduce_animation()
	return wish == 1 or WebPage.asks_for_reduced_motion()


## The student has chosen; it is kept for the next time.
static func reduce(wanted: bool) -> void:
	KeptChoices.keep(_KEY, "reduced" if wanted else "full")
