extends "res://addons/gut/test.gd"
## A picture of what does not move: drawn again whenever something in it has changed, and only then.

var _picture: StillPicture
var _panel: ScrollContainer
var _label: Label


func before_all() -> void:
	SoftwareDrawing.is_on = true


func after_all() -> void:
	SoftwareDrawing.is_on = false


func before_each() -> void:
	_picture = StillPicture.new()
	_panel = ScrollContainer.new()
	_panel.custom_minimum_size = Vector2(200.0, 40.0)
	_label = Label.new()
	_label.text = "one\ntwo\nthree\nfour"
	_panel.add_child(_label)
	_picture.add_child(_panel)
	add_child_autofree(_picture)
	await _settle()


func test_on_a_graphics_card_there_is_no_picture() -> void:
	SoftwareDrawing.is_on = false
	var plain := StillPicture.new()
	add_child_autofree(plain)
	assert_null(_canvas(plain))
	SoftwareDrawing.is_on = true


func test_nothing_is_drawn_again_while_nothing_changes() -> void:
	assert_false(await _is_drawn_again())


func test_another_text_is_drawn() -> void:
	_label.text = "five"
	assert_true(await _is_drawn_again())


func test_what_is_hidden_and_shown_is_drawn() -> void:
	_label.hide()
	assert_true(await _is_drawn_again())
	_label.show()
	assert_true(await _is_drawn_again())


func test_what_is_scrolled_is_drawn() -> void:
	_panel.scroll_vertical = 20
	assert_true(await _is_drawn_again())


func test_what_comes_later_is_drawn_and_its_changes_too() -> void:
	var late := VBoxContainer.new()
	var late_label := Label.new()
	late.add_child(late_label)
	_picture.add_child(late)
	assert_true(await _is_drawn_again())
	late_label.text = "late"
	assert_true(await _is_drawn_again())
	late.queue_free()
	assert_true(await _is_drawn_again())


func test_what_comes_back_is_watched_once() -> void:
	_panel.remove_child(_label)
	_panel.add_child(_label)
	await _settle()
	assert_false(await _is_drawn_again())
	_label.text = "back"
	assert_true(await _is_drawn_again())


func test_the_picture_is_as_large_as_what_it_shows() -> void:
	_panel.custom_minimum_size = Vector2(300.0, 90.0)
	await _settle()
	assert_eq(_canvas().size_2d_override, Vector2i(_picture.size))
	assert_gte(_picture.size.x, 300.0)


func test_only_a_see_through_picture_is_mixed_with_what_lies_below() -> void:
	assert_false(_canvas().transparent_bg)
	assert_string_contains(_shader_of(_picture), "blend_disabled")
	var card := StillPicture.new()
	card.is_see_through = true
	add_child_autofree(card)
	assert_true(_canvas(card).transparent_bg)
	assert_string_contains(_shader_of(card), "blend_premul_alpha")


func test_a_picture_that_stays_is_put_on_the_screen_only_with_what_has_changed() -> void:
	await _let_it_stay()
	assert_false(_picture.is_put_on_screen)
	_label.text = "five"
	await get_tree().process_frame
	assert_true(_picture.is_put_on_screen)
	_draw_frame()
	assert_false(_picture.is_put_on_screen)


func test_a_picture_that_stays_is_put_where_it_has_moved() -> void:
	await _let_it_stay()
	(_picture.get_parent() as Control).position.x += 10.0
	await get_tree().process_frame
	assert_true(_picture.is_put_on_screen)


func test_a_picture_that_stays_is_put_below_a_menu_and_where_the_menu_was() -> void:
	await _let_it_stay()
	var menu := PopupMenu.new()
	add_child_autofree(menu)
	menu.popup()
	_draw_frame()
	assert_true(_picture.is_put_on_screen)
	menu.hide()
	_draw_frame()
	assert_false(_picture.is_put_on_screen)


func test_a_window_of_another_size_has_to_show_it_again() -> void:
	await _let_it_stay()
	get_viewport().size_changed.emit()
	assert_true(_picture.is_put_on_screen)


func test_only_a_picture_that_stays_is_ever_left_out() -> void:
	_draw_frame()
	assert_true(_picture.is_put_on_screen)


func _let_it_stay() -> void:
	var place := Control.new()
	add_child_autofree(place)
	_picture.free()
	_picture = StillPicture.new()
	_picture.stays_on_screen = true
	_label = Label.new()
	_picture.add_child(_label)
	place.add_child(_picture)
	await _settle()
	_draw_frame()


# Without a screen the engine draws nothing.
func _draw_frame() -> void:
	RenderingServer.frame_post_draw.emit()


func _shader_of(picture: StillPicture) -> String:
	return (picture.material as ShaderMaterial).shader.code


func _canvas(of: StillPicture = _picture) -> StillCanvas:
	for child in of.get_children(true):
		if child is StillCanvas:
			return child as StillCanvas
	return null


# A container needs a frame or two to place what is in it.
func _settle() -> void:
	for frame: int in 4:
		await get_tree().process_frame


func _is_drawn_again() -> bool:
	_canvas().render_target_update_mode = SubViewport.UPDATE_DISABLED
	await _settle()
	return _canvas().render_target_update_mode == SubViewport.UPDATE_ONCE
