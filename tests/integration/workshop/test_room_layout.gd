extends WorkshopTest
## The workshop's own screens in windows of every size, with large text and in Dutch: nothing is cut
## off, lies on something else or is too small.

const _SIZES: Array[Vector2i] = [
	Vector2i(390, 844),
	Vector2i(844, 390),
	Vector2i(800, 600),
	Vector2i(1280, 720),
	Vector2i(1920, 1080),
]

var _language := ""


func before_each() -> void:
	super.before_each()
	_language = TranslationServer.get_locale()


func after_each() -> void:
	TranslationServer.set_locale(_language)
	await super.after_each()
	WindowFit.fit(student.window)


func test_they_fit() -> void:
	await _look_at_all("")


func test_they_fit_with_large_text() -> void:
	KeptChoices.keep("text_size", WindowFit.TEXT_SIZES[-1])
	await _look_at_all(", with large text")


func test_they_fit_in_dutch_with_a_long_sentence() -> void:
	TranslationServer.set_locale("nl")
	write("dot", "var own := normalized()\n\treturn x * other.x + y * other.y")
	write("rotate_around", "rotate(angle)\n\tx -= point.x\n\ty -= point.y")
	look_again()
	await _look_at_all(", in Dutch")


func _look_at_all(how: String) -> void:
	await judged()
	for size in _SIZES:
		await resize(size)
		for open: Callable in [
			open_start_screen,
			WorkshopWays.open_rubric.bind(get_tree()),
			WorkshopWays.open_rotation.bind(get_tree()),
		]:
			await open.call()
			await student.settle()
			await student.settle()
			await _look("%s at %s%s" % [screen().name, size, how])
			screen().free()


func _look(where: String) -> void:
	if Layout.problems(screen()):
		await student.settle()
	assert_eq(", ".join(Layout.problems(screen())), "", where)
	var survey := LayoutSurvey.new()
	survey.measure(screen(), where)
	assert_eq(survey.problems, {} as Dictionary[String, String], where)
