class_name BoardLink
extends RefCounted
## The link to the board of an open lesson: opens one, and copies the one to the board as it is.

# A longer link is shown with this many letters.
const _LONGEST_SHOWN := 60

var _id: String
var _lesson: Lesson
var _view: LinkView
var _first: Dictionary


## For the lesson [param id] in [param view], which has just been started.
func _init(id: String, view: FrameView) -> void:
	_id = id
	_lesson = view.lesson
	_view = LinkView.new(view)
	_first = _lesson.link_state()


## Shows what [param text_of_state] says of the board, as [LessonLink] reads it, and of the view, as
## [LinkView] does. "" if that could be done; else one sentence on what is wrong, and nothing has
## changed.
func open(text_of_state: String) -> String:
	var board_text := _view.board_part(text_of_state)
	var link := _read(board_text)
	if not link.problem:
		link.problem = _view.problem_in(text_of_state)
	if link.problem:
		return TranslationServer.translate("This link cannot be opened: %s") % link.problem
	_lesson.show_link(link.state)
	if board_text:
		_lesson.stop_opening()
	_view.show(text_of_state)
	return ""


## The text behind # in a link to the board as it is: `dot_product?a=7,1&step=4`.
func text() -> String:
	var parts: PackedStringArray = []
	for part: String in [_board_text(), _view.text()]:
		if part:
			parts.append(part)
	return "%s?%s" % [_id, "&".join(parts)] if parts else _id


## "" if the board as it is can be put into a link; else one sentence on why it cannot.
func problem() -> String:
	var found := _read(_board_text()).problem
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


# A lesson in which nothing was done yet is at its start, wherever its opening has moved it.
func _board_text() -> String:
	var state := _first if _lesson.is_opening() else _lesson.link_state()
	return LessonLink.text_of(state, _lesson.link_base(_first, state))


func _read(board_text: String) -> LessonLink:
	var link := LessonLink.read(board_text, _first)
	if not link.problem:
		link = LessonLink.read(board_text, _lesson.link_base(_first, link.state))
	if not link.problem:
		link.problem = _lesson.link_problem(link.state)
	return link
