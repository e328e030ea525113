class_name BallLessonTest
extends ScreenTest
## The base of the tests that drive the lessons on a ball and a line.


## The numbers that the lesson's state has now under this name.
func numbers(key: String) -> PackedFloat64Array:
	var held: PackedFloat64Array = frame().lesson.state()[key]
	return held


## Where a point of the plane is on the screen.
func place(x: float, y: float) -> Vector2:
	var lesson := frame().lesson
	return lesson.get_global_transform() * lesson.board.to_screen(Vec2.new(x, y))


## Drags from one point of the plane to another.
func drag(from: Vec2, to: Vec2) -> void:
	await student.drag(place(from.x, from.y), place(to.x, to.y))


func field(title: String) -> LineEdit:
	return Screen.named(screen(), title) as LineEdit


func formula_lines() -> PackedStringArray:
	return Screen.lines(frame().lesson.services[&"formula"] as Formula)


## The text in a row of the readout, counted from 1 below the headings, and a column, from 0.
func readout_text(row: int, column: int) -> String:
	var readout := frame().lesson.services[&"readout"] as Readout
	return readout.cell(row, column).text


## Whether each of the named parts of the drawing is visible.
func seen(names: Array[String]) -> Array[bool]:
	var found: Array[bool] = []
	for part in names:
		found.append((frame().lesson.get_node(part) as CanvasItem).visible)
	return found


## Picks the mistake whose line in the list begins with this text, by the keyboard.
func pick_mistake(heading: String) -> void:
	var list := frame().lesson.services[&"mistakes"].get_node("%List") as OptionButton
	list.grab_focus()
	await student.press(&"ui_accept")
	for i: int in list.item_count + 1:
		var focused := list.get_popup().get_focused_item()
		if focused < 0 or not list.get_item_text(focused).begins_with(heading):
			await student.press(&"ui_down")
	await student.press(&"ui_accept")
