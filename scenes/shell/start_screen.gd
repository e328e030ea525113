extends PanelContainer
## The start screen: a card for every lesson, in the order of the index.

const _CARD := preload("res://scenes/shell/lesson_card.tscn")

## The lesson from which the student comes back: its card has the focus. Null at the first start.
var came_from: LessonInfo

@onready var _scroll: ScrollContainer = %Scroll
@onready var _cards: HFlowContainer = %Cards


func _ready() -> void:
	LabText.choose_language()
	InputActions.load_packed()
	WindowFit.follow(get_window())
	Signs.add_to_font()
	for lesson in LessonIndex.lessons():
		_add_card(lesson)
	_focus(came_from)
	open_requested(LessonRequest.take_id())
	WebPage.follow_fragment(_follow_link)
	PageText.tell_page(self, [self])


## Opens the lesson with this id, or says which ids there are; does nothing for "".
func open_requested(id: String) -> void:
	if not id:
		return
	var lesson := LessonIndex.find(id)
	if lesson:
		Navigation.open_lesson(get_tree(), lesson)
	else:
		(%Notice as Label).text = LessonIndex.refusal(id)
		(%NoticePlace as Control).show()
		_bring_into_sight(%NoticePlace as Control)


func _follow_link(text: String) -> void:
	LessonRequest.ask(text)
	open_requested(LessonRequest.take_id())


func _add_card(lesson: LessonInfo) -> void:
	var card := _CARD.instantiate() as LessonCard
	_cards.add_child(card)
	card.show_lesson(lesson)
	card.pressed.connect(func() -> void: Navigation.open_lesson(get_tree(), lesson))


# The card of a lesson, or the first one where there is none for it.
func _focus(lesson: LessonInfo) -> void:
	var place := maxi(LessonIndex.lessons().find(lesson), 0)
	var card := _cards.get_child(place) as Control
	card.grab_focus()
	_bring_into_sight(card)


# The cards have their places only after they are laid out, which takes two frames.
func _bring_into_sight(part: Control) -> void:
	for frame: int in 2:
		await get_tree().process_frame
	_scroll.ensure_control_visible(part)
