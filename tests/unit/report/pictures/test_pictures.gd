extends LabTest
## The picture of a problem: axes, markers, and the text of the file.


func test_decades_are_spread_evenly() -> void:
	var axis := LogAxis.new([1e-3, 1e3])
	assert_almost_eq(axis.place(1e-3), 0.0, 1e-12)
	assert_almost_eq(axis.place(1.0), 0.5, 1e-12)
	assert_almost_eq(axis.place(1e3), 1.0, 1e-12)


func test_the_axis_reaches_to_whole_decades() -> void:
	var axis := LogAxis.new([0.02, 35.0])
	assert_eq([axis.first, axis.last], [-2, 2])


func test_zero_has_a_row_below_and_no_answer_one_above() -> void:
	var axis := LogAxis.new([0.0, 1.0, 10.0, Measurement.NO_ANSWER])
	assert_eq([axis.place(0.0), axis.place(Measurement.NO_ANSWER)], [0.0, 1.0])
	assert_almost_eq(axis.place(1.0), 1.0 / 3.0, 1e-12)
	assert_almost_eq(axis.place(10.0), 2.0 / 3.0, 1e-12)


func test_an_axis_without_any_number_still_has_a_place_for_all() -> void:
	var axis := LogAxis.new([0.0, Measurement.NO_ANSWER])
	assert_eq([axis.place(0.0), axis.place(Measurement.NO_ANSWER)], [0.0, 1.0])


func test_labels_are_powers_of_ten() -> void:
	assert_eq(LogAxis.label(1e-12), "10⁻¹²")
	assert_eq(LogAxis.label(1000.0), "10³")
	assert_eq([LogAxis.label(0.0), LogAxis.label(Measurement.NO_ANSWER)], ["0", "none"])


func test_there_are_never_more_labels_than_fit() -> void:
	var axis := LogAxis.new([1e-15, 1e5])
	assert_eq(axis.ticks(20).size(), 21)
	assert_lte(axis.ticks(8).size(), 9)


func test_methods_differ_in_shape_and_colour_and_baselines_are_hollow() -> void:
	var rows: Array[Measurement] = []
	for i in 8:
		rows.append(_row("own %d" % i, false))
		rows.append(_row("baseline %d" % i, true))
	var looks: Dictionary[String, bool] = {}
	var markers := PlotMarker.for_methods(rows)
	for method in markers:
		var marker := markers[method]
		looks["%d %s" % [marker.shape, marker.is_hollow]] = true
		assert_eq(marker.is_hollow, method.begins_with("baseline"))
	assert_eq(looks.size(), 16)


func test_a_baseline_is_an_outline_on_paper() -> void:
	var paper := 'fill="%s"' % SvgText.paper()
	assert_string_contains(PlotMarker.new(1, true).element(0.0, 0.0, 5.0), paper)
	assert_false(PlotMarker.new(1, false).element(0.0, 0.0, 5.0).contains(paper))


func test_neighbours_in_the_legend_differ_in_colour_too() -> void:
	assert_ne(PlotMarker.new(0, false).color, PlotMarker.new(1, false).color)


func test_what_svg_takes_as_its_own_is_escaped() -> void:
	var picture := SvgText.new(10, 10)
	picture.text('a < b & "c"', 0.0, 0.0, 10, "#000000")
	assert_string_contains(picture.to_text(), "a &lt; b &amp; &quot;c&quot;")


func test_the_picture_is_well_formed_and_can_be_drawn() -> void:
	var text := _picture()
	var parser := XMLParser.new()
	assert_eq(parser.open_buffer(text.to_utf8_buffer()), OK)
	var image := Image.new()
	assert_eq(image.load_svg_from_string(text), OK)
	assert_eq(image.get_width(), 1200)


func test_the_picture_names_axes_situations_and_methods() -> void:
	var text := _picture()
	for words: String in [
		"One ball in a box", "µs per simulated second", "error, px", "slow &amp; sure"
	]:
		assert_string_contains(text, words)
	assert_string_contains(text, ">300 px/s</text>")
	assert_string_contains(text, ">frontier: none is better in both</text>")


func test_no_coordinate_of_the_picture_is_not_a_number() -> void:
	var text := _picture().to_lower()
	assert_false(text.contains("nan") or text.contains("inf"))


func test_only_points_on_the_frontier_have_a_ring() -> void:
	# One ring each for the fast one, the exact one and the legend, none for the beaten one.
	assert_eq(_picture().count('r="13"'), 3)


func _picture() -> String:
	var rows: Array[Measurement] = [
		_row("fast", true), _row("slow & sure", false), _row("beaten", false), _row("lost", true)
	]
	var numbers: Array[float] = [1.0, 50.0, 20.0, 0.0, 30.0, 60.0, 2.0, Measurement.NO_ANSWER]
	for i in rows.size():
		rows[i].run_time_us = numbers[2 * i]
		rows[i].error = numbers[2 * i + 1]
	return ProblemPicture.of(BallInBoxProblem.new(), rows)


func _row(method: String, is_baseline: bool) -> Measurement:
	var row := Measurement.new()
	row.problem = "ball_in_box"
	row.situation = "300 px/s"
	row.method = method
	row.is_baseline = is_baseline
	row.run_time_us = 10.0
	row.error = 1.0
	return row
