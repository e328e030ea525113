extends LabTest
## Impacts computed with twice the digits of a double, compared with 4000 answers that were computed
## with 60 digits and rounded to doubles. They may differ by that rounding only.

## The promised error, per unit of relative change in the input.
const PROMISED := 1.0 / 2.0 ** 100

var _table := ImpactTable.new("ball_segment")


func test_hit_or_miss_agrees_and_only_the_rounding_of_the_time_is_left() -> void:
	var wrong := PackedInt32Array()
	var errors := PackedFloat64Array()
	for row: int in _table.size():
		var impact := _solve(row)
		if impact.hit != _table.is_hit(row):
			wrong.append(row)
		elif impact.hit:
			errors.append(_time_error(impact, row))
	assert_eq(wrong, PackedInt32Array(), "rows in which hit or miss differs")
	assert_all_at_most(errors, 1.0, "time")


func test_the_normal_points_where_the_reference_says() -> void:
	var errors := PackedFloat64Array()
	for row: int in range(0, _table.size(), 7):
		var impact := _solve(row)
		if impact.hit:
			var wanted := Vec2.new(_table.at(row, "nx"), _table.at(row, "ny"))
			var error := impact.normal.to_vec2().normalized().distance_to(wanted)
			errors.append(error / (2.0 * EPSILON + PROMISED * _normal_condition(row)))
	assert_all_at_most(errors, 1.0, "normal")


func test_a_centre_on_the_line_itself_is_hit_from_where_it_comes() -> void:
	var line := LineSegment.new(Vec2.new(-8, 0), Vec2.new(8, 0))
	for down: float in [-1.0, 1.0]:
		var velocity := ExactVector.from_vec2(Vec2.new(3, down))
		var impact := ExactImpact.with_segment(
			ExactVector.from_vec2(Vec2.new()), velocity, 2.0, line
		)
		assert_true(impact.hit)
		assert_eq(signf(impact.normal.y.high), -down)


# The error as a share of what is allowed: half a unit in the last place for the rounding of the
# reference, and the promised error.
func _time_error(impact: ExactImpact, row: int) -> float:
	var wanted := _table.at(row, "t")
	var promised := PROMISED * maxf(_table.at(row, "condition"), wanted)
	var allowed := 0.5 * last_place(wanted) + promised if wanted > 0.0 else promised
	var error := absf(impact.time.error_of(wanted))
	return error / allowed if error > 0.0 else 0.0


# How far the normal turns per unit of relative change in the input, as the reference defines it.
func _normal_condition(row: int) -> float:
	var speed := Vec2.new(_table.at(row, "vx"), _table.at(row, "vy")).length()
	var place := Vec2.new(_table.at(row, "px"), _table.at(row, "py")).length()
	var start := Vec2.new(_table.at(row, "ax"), _table.at(row, "ay")).length()
	return 1.0 + (speed * _table.at(row, "condition") + place + start) / _table.at(row, "r")


func _solve(row: int) -> ExactImpact:
	return ExactImpact.with_segment(
		ExactVector.from_vec2(Vec2.new(_table.at(row, "px"), _table.at(row, "py"))),
		ExactVector.from_vec2(Vec2.new(_table.at(row, "vx"), _table.at(row, "vy"))),
		_table.at(row, "r"),
		LineSegment.new(
			Vec2.new(_table.at(row, "ax"), _table.at(row, "ay")),
			Vec2.new(_table.at(row, "bx"), _table.at(row, "by"))
		)
	)
