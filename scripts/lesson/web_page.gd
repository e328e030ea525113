class_name WebPage
extends RefCounted
## The page in the browser around the lab: its address, and what it is told. Where there is no page
## nothing happens.

# Who is told that the part of the address from # on has changed, or that the keyboard comes into
# the lab, and the callbacks for the page: they are freed if nothing keeps them.
static var _follower: Callable
static var _listener: JavaScriptObject
static var _enterer: Callable
static var _entrance: JavaScriptObject
static var _paster: Callable
static var _pasting: JavaScriptObject
static var _has_told_first_frame := false


## Whether the lab runs in a page.
static func is_there() -> bool:
	return OS.has_feature("web")


## The part of the address from # on; "" where there is none.
static func fragment() -> String:
	return str(JavaScriptBridge.eval("window.location.hash")) if is_there() else ""


## Puts [param text] behind the # of the address, or takes # away for "", as a new entry of the
## history or in place of the present one; tells no follower.
static func set_address(text: String, is_new: bool) -> void:
	var code := (
		"try{window.history.METHOD(null,'',%s||window.location.pathname+window.location.search)}"
		+ "catch{}"
	)
	var method := "pushState" if is_new else "replaceState"
	_run(code.replace("METHOD", method), "#" + text if text else "")


## The page shows [param title], of the lesson that is open; its own for "".
static func show_title(title: String) -> void:
	_run("window.vec2_lab?.show_title?.(%s)", title)


## Puts [param text] behind the # of the address, so that loading the page again keeps it, and has
## the page copy the address and say so; tells no follower.
static func copy_link(text: String) -> void:
	set_address(text, false)
	_run("window.vec2_lab?.copy_link?.()")


## From now on [param follower], and nobody else, is called with the part of the address from # on
## when the user has changed it.
static func follow_fragment(follower: Callable) -> void:
	_follower = follower
	if is_there() and not _listener:
		_listener = JavaScriptBridge.create_callback(_tell_follower)
		JavaScriptBridge.get_interface("window").call(&"addEventListener", "hashchange", _listener)


## From now on [param enterer], and nobody else, is called when the Tab key leads into the lab from
## what is in front of it.
static func follow_entering(enterer: Callable) -> void:
	_enterer = enterer
	if is_there() and not _entrance:
		_entrance = JavaScriptBridge.create_callback(_tell_enterer)
		var window := JavaScriptBridge.get_interface("window")
		window.call(&"addEventListener", "vec2_lab_entered", _entrance)


## From now on [param paster], and nobody else, is called with a text that is pasted. The engine
## itself has only what was in the clipboard before.
static func follow_pasting(paster: Callable) -> void:
	_paster = paster
	tell({"takesPaste": paster.is_valid()})
	if is_there() and not _pasting:
		_pasting = JavaScriptBridge.create_callback(_tell_paster)
		var window := JavaScriptBridge.get_interface("window")
		window.call(&"addEventListener", "vec2_lab_pasted", _pasting)


## Tells the page what it needs to know of the lab, by name: whether Tab and the wheel are for it.
static func tell(state: Dictionary) -> void:
	_run("window.vec2_lab?.tell?.(%s)", state)


## Has the browser keep [param text] under a key, so that it is there again even if the page is left
## in this moment: what is written to `user://` takes its time. "" forgets it.
static func keep(key: String, text: String) -> void:
	var code := (
		"(([key,text])=>{try{text?localStorage.setItem(key,text):localStorage.removeItem(key)}"
		+ "catch{}})(%s)"
	)
	_run(code, ["vec2_lab_" + key, text])


## What the browser keeps under a key; "" for nothing.
static func kept(key: String) -> String:
	if not is_there():
		return ""
	var code := "(key=>{try{return localStorage.getItem(key)??''}catch{return ''}})(%s)"
	return str(JavaScriptBridge.eval(code.replace("%s", JSON.stringify("vec2_lab_" + key))))


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


static func _run(code: String, value: Variant = "") -> void:
	if is_there():
		JavaScriptBridge.eval(code.replace("%s", JSON.stringify(value)))


static func _tell_follower(_event: Array) -> void:
	if _follower.is_valid():
		_follower.call(fragment())


static func _tell_enterer(_event: Array) -> void:
	if _enterer.is_valid():
		_enterer.call()


static func _tell_paster(event: Array) -> void:
	if _paster.is_valid():
		var pasted: JavaScriptObject = event[0]
		_paster.call(str(pasted.get("detail")))
