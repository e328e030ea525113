extends LabTest
## The drawing size that is fitted to a window.


func test_a_window_of_the_usual_size_or_smaller_is_drawn_pixel_by_pixel() -> void:
	for size: Vector2i in [
		Vector2i(1280, 720),
		Vector2i(720, 1280),
		Vector2i(800, 600),
		Vector2i(390, 844),
		Vector2i(844, 390),
		Vector2i(600, 600),
		Vector2i(1, 1),
	]:
		assert_eq(_drawing_size(size), size)


func test_in_a_large_window_everything_is_larger() -> void:
	assert_eq(_drawing_size(Vector2i(1920, 1080)), Vector2i(1280, 720))
	assert_eq(_drawing_size(Vector2i(3840, 2160)), Vector2i(1280, 720))
	assert_eq(_drawing_size(Vector2i(1440, 2560)), Vector2i(720, 1280))


func test_a_very_wide_window_is_not_drawn_smaller() -> void:
	assert_eq(_drawing_size(Vector2i(3840, 1080)), Vector2i(2560, 720))


func test_on_a_dense_screen_a_pixel_is_one_of_the_window() -> void:
	assert_eq(_drawing_size(Vector2i(1170, 2532), 3.0), Vector2i(390, 844))
	assert_eq(_drawing_size(Vector2i(2560, 1440), 2.0), Vector2i(1280, 720))


func test_larger_text_leaves_less_room() -> void:
	assert_eq(_drawing_size(Vector2i(1280, 720), 1.0, 1.25), Vector2i(1024, 576))
	assert_eq(_drawing_size(Vector2i(390, 844), 1.0, 1.5), Vector2i(260, 562))


func test_no_pixel_of_the_drawing_is_smaller_than_one_of_the_window() -> void:
	for width: int in range(300, 4000, 171):
		for height: int in range(300, 2200, 93):
			var drawn := Vector2(_drawing_size(Vector2i(width, height)))
			assert_gte(minf(width / drawn.x, height / drawn.y), 1.0)


func test_a_window_is_fitted_now_and_whenever_its_size_changes() -> void:
	var window := Window.new()
	window.size = Vector2i(800, 600)
	add_child_autofree(window)
	WindowFit.follow(window)
	assert_eq(window.content_scale_size, Vector2i(800, 600))
	window.size = Vector2i(720, 1280)
	assert_eq(window.content_scale_size, Vector2i(720, 1280))


func test_following_twice_changes_nothing() -> void:
	var window := Window.new()
	add_child_autofree(window)
	WindowFit.follow(window)
	WindowFit.follow(window)
	assert_eq(window.size_changed.get_connections().size(), 1)


func _drawing_size(window_size: Vector2i, density: float = 1.0, text: float = 1.0) -> Vector2i:
	return WindowFit.drawing_size(window_size, density, text)
