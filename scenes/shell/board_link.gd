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


## "" if the board as it is can be put into a link; else one sentence on why it cannot.
func problem() -> String:
	var found := _read(text().trim_prefix(_id).trim_prefix("?")).problem
	if not found:
		return ""
	return TranslationServer.translate("This board cannot be put into a link: %s") % found


## Copies the link to the board as it is: in a browser the page's whole address, else the text
## behind its #. Returns one sentence that says what was copied; "" where the page says it.
func copy() -> String:
	if WebPage.is_there():
		WebPage.copy_link(text())
		return ""
	var shown := "#" + text()
	if DisplayServer.has_feature(DisplayServer.FEATURE_CLIPBOARD):
		DisplayServer.clipboard_set(shown)
	if shown.length() > _LONGEST_SHOWN:
		shown = shown.left(_LONGEST_SHOWN) + "…"
	return (
		(
			TranslationServer
			. translate(
				"✓ Copied: %s It goes behind the address of the lab's page, or behind --lesson= as '%s'."
			)
		)
		% [shown, shown]
	)


func _read(text_of_state: String) -> LessonLink:
	var link := LessonLink.read(text_of_state, _first)
	if not link.problem:
		link = LessonLink.read(text_of_state, _lesson.link_base(_first, link.state))
	if not link.problem:
		link.problem = _lesson.link_problem(link.state)
	return link
