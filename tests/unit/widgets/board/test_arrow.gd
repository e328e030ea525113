extends LabTest
## Where the label of an arrow is drawn.

const _FROM := Vector2(500.0, 400.0)

var _arrow: Arrow


func before_each() -> void:
	var board := Board.new()
	board.size = Vector2(800.0, 600.0)
	add_child_autofree(board)
	_arrow = Arrow.new()
	_arrow.label = "line"
	board.add_child(_arrow)


func test_the_label_of_an_arrow_is_beyond_its_tip() -> void:
	var middle := _arrow._label_middle(_FROM, _FROM + Vector2(0.0, -100.0))
	assert_almost_eq(middle.x, _FROM.x, 1e-3)
	assert_lt(middle.y, 300.0)


# The line of a segment may go on beyond its end.
func test_the_label_of_a_line_is_not_on_the_line(
	degrees: float = use_parameters([0.0, 37.0, 90.0, 143.0, 180.0, 217.0, 270.0, 323.0])
) -> void:
	_arrow.has_tip = false
	var end := _FROM + Vector2.from_angle(deg_to_rad(degrees)) * 100.0
	var extent := ThemeDB.fallback_font.get_string_size("line", HORIZONTAL_ALIGNMENT_LEFT, -1, 24)
	var room := Rect2(_arrow._label_middle(_FROM, end), Vector2.ZERO)
	room = room.grow_individual(extent.x / 2.0, 9.0, extent.x / 2.0, 9.0)
	var beyond := end + (end - _FROM)
	var sides := [0, 0]
	for corner: Vector2 in [
		room.position,
		room.end,
		Vector2(room.position.x, room.end.y),
		Vector2(room.end.x, room.position.y)
	]:
		sides[0 if (beyond - _FROM).cross(corner - _FROM) > 0.0 else 1] += 1
	assert_has(sides, 4, "all corners of the label are on one side of the line")


func test_a_label_beside_can_be_nearer_to_the_head() -> void:
	_arrow.label_place = Arrow.LabelPlace.MIDDLE
	var to := _FROM + Vector2(-200.0, 0.0)
	assert_almost_eq(_arrow._label_middle(_FROM, to).x, 400.0, 1e-3)
	_arrow.label_share = 0.75
	assert_almost_eq(_arrow._label_middle(_FROM, to).x, 350.0, 1e-3)


func test_on_a_small_board_texts_are_smaller_and_can_still_be_read() -> void:
	assert_eq(_arrow.drawn_size(24), 24)
	_arrow.board.size = Vector2(390.0, 350.0)
	assert_eq(_arrow.drawn_size(24), 17)
	for font_size: int in [15, 18, 20]:
		assert_eq(_arrow.drawn_size(font_size), BoardPart.SMALLEST_TEXT)
	assert_lt(_arrow.text_extent("line", 24).y, 30.0)


func test_no_label_lies_where_a_card_covers_the_board() -> void:
	_arrow.board.keep_free(100.0, 80.0)
	for y: float in [-50.0, 20.0, 590.0, 2000.0]:
		var middle := _arrow._label_middle(_FROM, Vector2(_FROM.x, y))
		assert_between(middle.y, 122.0, 498.0)
