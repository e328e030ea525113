class_name WebPage
extends RefCounted
## The page in the browser around the lab: its address, and what it is told. Where there is no page
## nothing happens.

# Who is told that the part of the address from # on has changed, and the callback for the page: it
# is freed if nothing keeps it.
static var _follower: Callable
static var _listener: JavaScriptObject
static var _has_told_first_frame := false


## Whether the lab runs in a page.
static func is_there() -> bool:
	return OS.has_feature("web")


## The part of the address from # on; "" where there is none.
static func fragment() -> String:
	return str(JavaScriptBridge.eval("window.location.hash")) if is_there() else ""


## Puts [param text] behind the # of the address, so that loading the page again keeps it, and has
## the page copy the address and say so; tells no follower.
static func copy_link(text: String) -> void:
	_run("window.history.replaceState(null,'','#'+%s);window.vec2_lab?.copy_link?.()", text)


## From now on [param follower], and nobody else, is called with the part of the address from # on
## when the user has changed it.
static func follow_fragment(follower: Callable) -> void:
	_follower = follower
	if is_there() and not _listener:
		_listener = JavaScriptBridge.create_callback(_tell_follower)
		JavaScriptBridge.get_interface("window").call(&"addEventListener", "hashchange", _listener)


## Whether the person who uses the browser wants little to move by itself.
static func asks_for_reduced_motion() -> bool:
	var question := "String(window.matchMedia('(prefers-reduced-motion: reduce)').matches)"
	return is_there() and str(JavaScriptBridge.eval(question)) == "true"


## Gives the page the words that are on the screen, for people who do not see it.
static func show_text(text: String) -> void:
	_run("window.vec2_lab?.show_text?.(%s)", text)


## Tells the page, once, that the first frame has been drawn.
static func tell_first_frame() -> void:
	if not _has_told_first_frame:
		_has_told_first_frame = true
		_run("window.vec2_lab?.first_frame?.()")


static func _run(code: String, text: String = "") -> void:
	if is_there():
		JavaScriptBridge.eval(code.replace("%s", JSON.stringify(text)))


static func _tell_follower(_event: Array) -> void:
	if _follower.is_valid():
		_follower.call(fragment())
