extends LabTest
## The drawing size that is fitted to a window.


func test_wide_windows_are_drawn_720_high() -> void:
	assert_eq(WindowFit.drawing_size(Vector2i(1280, 720)), Vector2i(1280, 720))
	assert_eq(WindowFit.drawing_size(Vector2i(1920, 1080)), Vector2i(1280, 720))
	assert_eq(WindowFit.drawing_size(Vector2i(800, 600)), Vector2i(960, 720))


func test_tall_windows_are_drawn_720_wide() -> void:
	assert_eq(WindowFit.drawing_size(Vector2i(720, 1280)), Vector2i(720, 1280))
	assert_eq(WindowFit.drawing_size(Vector2i(360, 800)), Vector2i(720, 1280))


func test_a_square_window_counts_as_wide() -> void:
	assert_eq(WindowFit.drawing_size(Vector2i(600, 600)), Vector2i(960, 720))


func test_a_very_wide_window_is_not_drawn_smaller() -> void:
	assert_eq(WindowFit.drawing_size(Vector2i(3840, 1080)), Vector2i(1280, 720))


func test_a_window_is_fitted_now_and_whenever_its_size_changes() -> void:
	var window := Window.new()
	window.size = Vector2i(800, 600)
	add_child_autofree(window)
	WindowFit.follow(window)
	assert_eq(window.content_scale_size, Vector2i(960, 720))
	window.size = Vector2i(720, 1280)
	assert_eq(window.content_scale_size, Vector2i(720, 1280))


func test_following_twice_changes_nothing() -> void:
	var window := Window.new()
	add_child_autofree(window)
	WindowFit.follow(window)
	WindowFit.follow(window)
	assert_eq(window.size_changed.get_connections().size(), 1)
