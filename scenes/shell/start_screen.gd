extends PanelContainer
## The start screen: a card for every lesson, in the order of the index.

const _CARD := preload("res://scenes/shell/lesson_card.tscn")

@onready var _cards: HFlowContainer = %Cards


func _ready() -> void:
	LabText.choose_language()
	InputActions.load_packed()
	WindowFit.follow(get_window())
	Signs.add_to_font()
	for lesson in LessonIndex.lessons():
		_add_card(lesson)
	(_cards.get_child(0) as Control).grab_focus()
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


func _follow_link(text: String) -> void:
	LessonRequest.ask(text)
	open_requested(LessonRequest.take_id())


func _add_card(lesson: LessonInfo) -> void:
	var card := _CARD.instantiate() as LessonCard
	_cards.add_child(card)
	card.show_lesson(lesson)
	card.pressed.connect(func() -> void: Navigation.open_lesson(get_tree(), lesson))
