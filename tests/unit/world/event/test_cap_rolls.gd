extends LabTest
## Paths over round ends, cut into pieces of constant acceleration.

const _RADIUS := 10.0
const _GRAVITY := 500.0


func test_every_piece_stays_on_the_circle_and_ends_where_the_slide_is() -> void:
	var off_circle := PackedFloat64Array()
	var off_end := PackedFloat64Array()
	for speed: float in [5.0, 20.0, 50.0]:
		var rolls := _rolls(speed)
		var seconds := 0.0
		while rolls.duration(0) - seconds > CapRolls.LINE_TIME:
			rolls.begin_piece(0, seconds, _GRAVITY, _RADIUS)
			for part: int in 5:
				off_circle.append(absf(_flown(rolls, 0.25 * part).length() - _RADIUS))
			var end := _flown(rolls, 1.0)
			seconds += rolls.piece_seconds
			rolls.move_to(0, seconds)
			off_end.append(end.distance_to(Vec2.new(rolls.x, rolls.y)))
	assert_gt(off_end.size(), 100)
	assert_all_at_most(off_circle, CapRolls.OFF_CIRCLE)
	assert_all_at_most(off_end, 1e-12)


func test_a_slow_ball_is_over_the_line_before_its_slide_ends() -> void:
	# It starts 30 degrees beyond the end and moves uphill. At the top it is right above the end.
	var x := _RADIUS * sin(PI / 6.0)
	var y := -_RADIUS * cos(PI / 6.0)
	var slide := CapSlide.new()
	assert_no_refusal(
		slide.start(0, 0, x, y, -60.0 * cos(PI / 6.0), -60.0 * sin(PI / 6.0), 0, _GRAVITY)
	)
	var rolls := CapRolls.new()
	rolls.resize(1)
	rolls.begin(0, slide, 7.0, 0.0)
	rolls.end_at_line(0, -1.0, 0.0)
	rolls.move_to(0, rolls.duration(0))
	assert_lt(rolls.duration(0), slide.end_time)
	assert_vec2(Vec2.new(rolls.x, rolls.y), Vec2.new(0, -_RADIUS), 1e-9)


func test_time_is_counted_from_the_beginning_of_the_way() -> void:
	assert_eq(_rolls(20.0).seconds_since(0, 7.5, 1e-17), 0.5 + 1e-17)


func _rolls(speed: float) -> CapRolls:
	var slide := CapSlide.new()
	assert_no_refusal(slide.start(0, 0, 0, -_RADIUS, speed, 0, 0, _GRAVITY))
	var rolls := CapRolls.new()
	rolls.resize(1)
	rolls.begin(0, slide, 7.0, 0.0)
	rolls.end_at_line(0, -1.0, 0.0)
	return rolls


# Where the ball is after this share of the piece.
static func _flown(rolls: CapRolls, share: float) -> Vec2:
	var seconds := share * rolls.piece_seconds
	return Vec2.new(
		rolls.x + (rolls.velocity_x + 0.5 * rolls.pull_x * seconds) * seconds,
		rolls.y + (rolls.velocity_y + 0.5 * rolls.pull_y * seconds) * seconds
	)
