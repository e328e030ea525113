class_name NewtonBallsKeys
extends Node
## The keys of the lesson on balls that meet. N is the next step in every lesson, so Newton's laws
## are switched by A, for action and reaction.

## Newton's laws should be switched on, or off if they are on.
signal newton_wanted
## Another of the usual bouncinesses should be taken.
signal bounciness_wanted

## The actions for the help line, with what each does in a word: source text.
const ACTIONS: Dictionary[StringName, String] = {
	&"lab_newton": "Newton on or off",
	&"lab_next_bounciness": "bounciness",
}


func _unhandled_input(event: InputEvent) -> void:
	if event.is_action_pressed(&"lab_newton", false, true):
		newton_wanted.emit()
	elif event.is_action_pressed(&"lab_next_bounciness", false, true):
		bounciness_wanted.emit()
