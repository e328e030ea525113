class_name BoardLink
extends RefCounted
## The link to the board of an open lesson: opens one, and copies the one to the board as it is.

# A longer link is shown with this many letters.
const _LONGEST_SHOWN := 60

var _id: String
var _lesson: Lesson
var _first: Dictionary


## For [param lesson], which has just been started.
func _init(id: String, lesson: Lesson) -> void:
	_id = id
	_lesson = lesson
	_first = lesson.link_state()


## Shows the state [param text_of_state], as [LessonLink] reads it. "" if that could be done; else
## one sentence on what is wrong, and nothing has changed.
func open(text_of_state: String) -> String:
	var link := _read(text_of_state)
	if not link.problem:
		_lesson.show_link(link.state)
		return ""
	return TranslationServer.translate("This link cannot be opened: %s") % link.problem


## The text behind # in a link to the board as it is: `dot_product?a=7,1`.
func text() -> String:
	var state := _lesson.link_state()
	var differing := LessonLink.text_of(state, _lesson.link_base(_first, state))
	return "%s?%s" % [_id, differing] if differing else _id


## Copies the link to the board as it is: in a browser the page's whole address, else the text
## behind its #. Returns one sentence that says what was copied.
func copy() -> String:
	var whole := text()
	var problem := _read(whole.trim_prefix(_id).trim_prefix("?")).problem
	if problem:
		return TranslationServer.translate("This board cannot be put into a link: %s") % problem
	if WebPage.is_there():
		WebPage.put_fragment(whole)
		DisplayServer.clipboard_set(WebPage.address())
		return TranslationServer.translate("Link copied. It is in the address bar, too.")
	_put_into_clipboard("#" + whole)
	var shown := "#" + whole
	if shown.length() > _LONGEST_SHOWN:
		shown = shown.left(_LONGEST_SHOWN) + "…"
	return (
		TranslationServer.translate(
			"Copied: %s It goes behind the address of the lab's page, or behind --lesson= as '%s'."
		)
		% [shown, shown]
	)


func _put_into_clipboard(link: String) -> void:
	if DisplayServer.has_feature(DisplayServer.FEATURE_CLIPBOARD):
		DisplayServer.clipboard_set(link)


func _read(text_of_state: String) -> LessonLink:
	var link := LessonLink.read(text_of_state, _first)
	if not link.problem:
		link = LessonLink.read(text_of_state, _lesson.link_base(_first, link.state))
	if not link.problem:
		link.problem = _lesson.link_problem(link.state)
	return link
