class_name LessonTest
extends ScreenTest
## The base of the tests that drive a lesson as a student does.


## The numbers that the lesson's state has now under this name.
func numbers(key: String) -> PackedFloat64Array:
	var held: PackedFloat64Array = frame().lesson.state()[key]
	return held


## The lesson's state has these numbers now under this name.
func assert_numbers(key: String, wanted: Array[float]) -> void:
	assert_eq(numbers(key), PackedFloat64Array(wanted), key)


## Where a point of the plane is on the screen.
func place(x: float, y: float) -> Vector2:
	return place_of(Vec2.new(x, y))


## The same for a point that is a vector.
func place_of(point: Vec2) -> Vector2:
	var lesson := frame().lesson
	return lesson.get_global_transform() * lesson.board.to_screen(point)


## Drags from one point of the plane to another.
func drag(from: Vec2, to: Vec2) -> void:
	await student.drag(place_of(from), place_of(to))


func field(title: String) -> LineEdit:
	return Screen.named(screen(), title) as LineEdit


## Types a text over what is in the field with this name.
func enter(title: String, text: String) -> void:
	await student.enter(field(title), text)


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


## Picks the item with this title in the list with this name, by the keyboard.
func pick(name_of_list: String, title: String) -> void:
	var list := Screen.named(screen(), name_of_list) as OptionButton
	var item := 0
	while item + 1 < list.item_count and list.get_item_text(item) != title:
		item += 1
	await _pick_at(list, item)


## Picks a mistake by its place in the list, from 0 for none, by the keyboard.
func pick_mistake_at(item: int) -> void:
	await _pick_at(Screen.named(screen(), "Known mistakes") as OptionButton, item)


## Plays until what moves has stopped by itself, faster than it does.
func play_to_end() -> void:
	await click_button("Play or pause")
	var transport := frame().lesson.services[&"transport"] as Transport
	Engine.time_scale = 20.0
	for wait: int in 3000:
		if not transport.is_playing:
			break
		await get_tree().process_frame
	Engine.time_scale = 1.0


func _pick_at(list: OptionButton, item: int) -> void:
	await student.click(list)
	for press: int in list.item_count:
		await student.press_key(KEY_UP)
	for press: int in item:
		await student.press_key(KEY_DOWN)
	await student.press_key(KEY_ENTER)
