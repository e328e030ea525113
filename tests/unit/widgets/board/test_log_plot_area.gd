extends LabTest
## Tests of where points lie in a plot with logarithmic axes: faster to the left, closer below, zero
## at the bottom and no answer at the top. No point is lost.

const FIELD := Rect2(80.0, 40.0, 600.0, 400.0)


func test_a_faster_point_is_further_left_and_a_closer_one_lower() -> void:
	var pixels := _pixels([[1.0, 5.0], [100.0, 1e-3]])
	assert_lt(pixels[0].x, pixels[1].x)
	assert_lt(pixels[0].y, pixels[1].y)


func test_zero_lies_at_the_foot_below_the_smallest_error() -> void:
	var pixels := _pixels([[1.0, 0.0], [2.0, 1e-300 * 1e270], [3.0, 10.0]])
	assert_gt(pixels[0].y, pixels[1].y)
	assert_true(FIELD.has_point(pixels[0]))


func test_no_answer_lies_at_the_top_above_the_largest_error() -> void:
	for error: float in [INF, NAN, 1e200]:
		var pixels := _pixels([[1.0, error], [2.0, 1e11], [3.0, 0.0]])
		assert_lt(pixels[0].y, pixels[1].y, str(error))
		assert_true(FIELD.has_point(pixels[0]))


func test_every_point_lies_in_the_field() -> void:
	var values: Array[Array] = []
	for exponent: int in range(-20, 12):
		values.append([10.0 ** (exponent % 5) * 3.0, 10.0 ** exponent * 7.0])
	for pixel in _pixels(values):
		assert_true(FIELD.grow(0.01).has_point(pixel), str(pixel))


func test_a_run_time_of_zero_stays_at_the_left_edge() -> void:
	assert_eq(_pixels([[0.0, 1.0], [5.0, 1.0]])[0].x, FIELD.position.x)


func _pixels(values: Array[Array]) -> PackedVector2Array:
	var points: Array[PlotPoint] = []
	for pair in values:
		var x: float = pair[0]
		var y: float = pair[1]
		points.append(PlotPoint.new(x, y, 0, []))
	var area := LogPlotArea.new()
	area.field = FIELD
	area.fit(points)
	var pixels: PackedVector2Array = []
	for point in points:
		pixels.append(area.pixel(point))
	return pixels
