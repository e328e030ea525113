class_name Keyboard
extends RefCounted
## Whether there is a keyboard: what its keys do is told only then.

## On a screen that can be touched there may be none, until one of its keys is pressed: then set it.
static var is_there := not DisplayServer.is_touchscreen_available()
