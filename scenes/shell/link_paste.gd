class_name LinkPaste
extends Node
## Ctrl+V opens the link in the clipboard where no field has the focus. On the desktop only: in a
## browser a link goes into the address.

## Reads the clipboard; tests have one of their own.
static var clipboard := DisplayServer.clipboard_get

var _follow: Callable
var _refuse: Callable


## Calls [param follow] with the text of a link, or [param refuse] with a sentence on why there is
## none.
func _init(follow: Callable, refuse: Callable) -> void:
	_follow = follow
	_refuse = refuse


func _unhandled_input(event: InputEvent) -> void:
	if WebPage.is_there() or not event.is_action_pressed(&"ui_paste"):
		return
	var text: String = clipboard.call()
	if LessonRequest.id_in(text):
		_follow.call(text)
	else:
		_refuse.call(tr("The clipboard holds no link. One looks like this: #dot_product?a=7,1"))
