class_name DotProductTest
extends ScreenTest
## The base of the tests that drive the lesson on the dot product.


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"dot_product"))


## Tail and head of a vector, `a` or `b`, as the lesson now holds them: four numbers.
func ends(letter: String) -> PackedFloat64Array:
	var stored := frame().lesson.state()
	var tail: PackedFloat64Array = stored[letter + "_from"]
	var head: PackedFloat64Array = stored[letter]
	return tail + head


## Where a point of the plane is on the screen.
func place(x: float, y: float) -> Vector2:
	var lesson := frame().lesson
	return lesson.get_global_transform() * lesson.board.to_screen(Vec2.new(x, y))


## Drags from one point of the plane to another.
func drag(from: Vec2, to: Vec2, with_shift: bool = false) -> void:
	await student.drag(place(from.x, from.y), place(to.x, to.y), with_shift)


func field(title: String) -> LineEdit:
	return Screen.named(screen(), title) as LineEdit


func formula_lines() -> PackedStringArray:
	return Screen.lines(frame().lesson.services[&"formula"] as Formula)


## The notice that lies over the board; "" while there is none.
func notice() -> String:
	var label := frame().get_node("%Notice") as Label
	return label.text if label.is_visible_in_tree() else ""


func assert_a(numbers: PackedFloat64Array, text: String = "") -> void:
	assert_eq(ends("a"), numbers, "tail and head of a. " + text)


func assert_b(numbers: PackedFloat64Array, text: String = "") -> void:
	assert_eq(ends("b"), numbers, "tail and head of b. " + text)
