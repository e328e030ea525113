extends ScreenTest
## What a lesson's card shows: the board alone, without text.

const CardPicture := preload("res://tools/draw/card_picture.gd")


func after_each() -> void:
	student.window.content_scale_factor = 1.0
	await super.after_each()


func test_every_card_has_a_picture_of_one_size() -> void:
	for lesson: LessonInfo in LessonIndex.lessons():
		var picture := load(lesson.card_path()) as Texture2D
		assert_eq(Vector2i(picture.get_size()), CardPicture.SIZE, lesson.id)


func test_a_card_shows_the_board_alone() -> void:
	await open_lesson(LessonIndex.find(&"dot_product"))
	await go_to_step()
	CardPicture.show_board_alone(frame())
	await student.settle()
	var board := frame().lesson.board.get_global_rect()
	assert_true(board.grow(1.0).encloses(frame().get_global_rect()), str(board))
	for control: Control in Screen.controls(frame()):
		if Screen.text_of(control) and not control is Handle:
			assert_eq(_opacity(control), 0.0, Screen.text_of(control))


func _opacity(control: Control) -> float:
	var opacity := 1.0
	var above: Node = control
	while above is Control:
		opacity *= (above as Control).modulate.a
		above = above.get_parent()
	return opacity
