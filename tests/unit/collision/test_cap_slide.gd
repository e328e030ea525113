extends LabTest
## Sliding over the round end of a line, compared with closed formulas and with an integration in
## small steps that does not use energy.

const _RADIUS := 12.0
const _GRAVITY := 300.0
const _STEPS := 6000

# Angle from the top in degrees, and angular speed in units of sqrt(g / R). Some slide away from the
# top, some over it, and some turn back on their way up.
const _STARTS: Array[Array] = [
	[10.0, 0.0],
	[-50.0, 0.0],
	[0.001, 0.0],
	[20.0, 0.4],
	[-30.0, 0.6],
	[0.0, 0.3],
	[-40.0, -0.2],
	[25.0, -0.3],
	[-60.0, 0.5],
	[44.0, -0.7],
]

var _slide := CapSlide.new()


func test_from_rest_near_the_top_it_leaves_at_two_thirds_of_the_height() -> void:
	_start(1e-6, 0.0)
	_slide.move_to(_slide.end_time)
	assert_eq(_slide.ending, CapSlide.Ending.LEAVES)
	assert_almost_eq(-_slide.position_y / _RADIUS, 2.0 / 3.0, 1e-12)


func test_it_leaves_where_the_cap_no_longer_pushes() -> void:
	for start: Array in _STARTS:
		_start_at(start)
		if _slide.ending == CapSlide.Ending.LEAVES:
			_slide.move_to(_slide.end_time)
			var squared := _slide.velocity_x ** 2 + _slide.velocity_y ** 2
			var inwards := -_GRAVITY * _slide.position_y / _RADIUS
			assert_almost_eq(squared / _RADIUS / inwards, 1.0, 1e-14, str(start))


func test_energy_stays_the_same_all_the_way() -> void:
	var errors := PackedFloat64Array()
	for start: Array in _STARTS:
		_start_at(start)
		_slide.move_to(0.0)
		var energy := _energy()
		for part: int in range(1, 21):
			_slide.move_to(_slide.end_time * part / 20.0)
			errors.append(absf(_energy() - energy) / (_GRAVITY * _RADIUS))
	assert_all_at_most(errors, 1e-14)


func test_small_steps_arrive_at_the_same_place_at_the_same_time() -> void:
	for start: Array in _STARTS:
		_start_at(start)
		for part: float in [0.1, 0.5, 0.77, 1.0]:
			var seconds := _slide.end_time * part
			_slide.move_to(seconds)
			var stepped := _stepped(_radians(start), _angular_speed(start), seconds)
			var angle := atan2(_slide.position_x, -_slide.position_y)
			var across := _slide.velocity_x * cos(angle) + _slide.velocity_y * sin(angle)
			assert_almost_eq(angle, stepped[0], 1e-11, "%s, part %s" % [start, part])
			assert_almost_eq(across / _RADIUS, stepped[1], 1e-10, "%s, part %s" % [start, part])


func test_a_small_angle_grows_as_the_hyperbolic_cosine() -> void:
	_start(1e-7, 0.0)
	for angle: float in [1.0001e-7, 1.5e-7, 1e-6, 1e-5]:
		var wanted := acosh(angle / 1e-7) / sqrt(_GRAVITY / _RADIUS)
		var seconds := _slide.time_to_direction(sin(angle), -cos(angle))
		assert_almost_eq(seconds, wanted, 1e-10 * wanted)


func test_uphill_with_too_little_it_is_back_at_the_start_with_the_reversed_velocity() -> void:
	_start(-0.9, 0.7)
	assert_eq(_slide.ending, CapSlide.Ending.RETURNS)
	_slide.move_to(0.0)
	var before := Vec2.new(_slide.velocity_x, _slide.velocity_y)
	_slide.move_to(_slide.end_time)
	assert_vec2(Vec2.new(_slide.velocity_x, _slide.velocity_y), before.negated(), 1e-13)
	assert_vec2(
		Vec2.new(_slide.position_x, _slide.position_y), _place(-0.9), 1e-14, "where it started"
	)
	# At half the time it is at rest, as high as its speed takes it.
	_slide.move_to(0.5 * _slide.end_time)
	assert_almost_eq(absf(_slide.velocity_x) + absf(_slide.velocity_y), 0.0, 1e-12)
	var height := before.length_squared() / (2.0 * _GRAVITY)
	assert_almost_eq(-_slide.position_y, _RADIUS * cos(0.9) + height, 1e-13)


func test_a_push_that_hardly_moves_it_is_over_after_twice_speed_over_pull() -> void:
	# It moves by 1e-12 radians: the difference of the two angles alone would leave 4 digits.
	_start(-0.7, 1e-6)
	var wanted := 2e-6 / sin(0.7) / sqrt(_GRAVITY / _RADIUS)
	assert_eq(_slide.ending, CapSlide.Ending.RETURNS)
	assert_almost_eq(_slide.end_time, wanted, 1e-11 * wanted)


func test_just_enough_speed_parts_the_ways() -> void:
	var speed := 2.0 * sin(0.2)
	_start(-0.4, speed * (1.0 - 1e-9))
	assert_eq(_slide.ending, CapSlide.Ending.RETURNS)
	var long := _slide.end_time
	_start(-0.4, speed * (1.0 + 1e-9))
	assert_eq(_slide.ending, CapSlide.Ending.LEAVES)
	_start(-0.4, 0.5 * speed)
	assert_lt(3.0 * _slide.end_time, long)


func test_at_rest_on_the_top_it_stays() -> void:
	_start(0.0, 0.0)
	assert_eq([_slide.ending, _slide.end_time], [CapSlide.Ending.NEVER, INF])
	_slide.move_to(1e6)
	assert_eq([_slide.position_x, _slide.position_y], [0.0, -_RADIUS])
	assert_eq([_slide.velocity_x, _slide.velocity_y], [0.0, 0.0])


func test_too_fast_or_below_it_leaves_at_once() -> void:
	for start: Vec2 in [Vec2.new(0, 1.0001), Vec2.new(0.5, 1.1), Vec2.new(-0.5, 1.1)]:
		_start(start.x, start.y)
		assert_eq([_slide.ending, _slide.end_time], [CapSlide.Ending.LEAVES, 0.0], str(start))
	_start(2.0, 0.0)
	assert_eq([_slide.ending, _slide.end_time], [CapSlide.Ending.LEAVES, 0.0])
	_slide.move_to(0.0)
	assert_vec2(Vec2.new(_slide.position_x, _slide.position_y), _place(2.0), 1e-14)


func test_without_gravity_it_rests_or_flies_off() -> void:
	assert_no_refusal(_slide.start(0, 0, 3, 4, 0, 0, 0, 0))
	assert_eq(_slide.ending, CapSlide.Ending.NEVER)
	assert_no_refusal(_slide.start(0, 0, 3, 4, -4, 3, 0, 0))
	assert_eq([_slide.ending, _slide.end_time], [CapSlide.Ending.LEAVES, 0.0])
	_slide.move_to(0.0)
	assert_vec2(Vec2.new(_slide.velocity_x, _slide.velocity_y), Vec2.new(-4, 3), 1e-15)


func test_only_the_velocity_along_the_circle_counts() -> void:
	assert_no_refusal(_slide.start(0, 0, 3, -4, 4 + 30, 3 - 40, 0, 10))
	_slide.move_to(0.0)
	assert_vec2(Vec2.new(_slide.velocity_x, _slide.velocity_y), Vec2.new(4, 3), 1e-14)


func test_turned_and_moved_the_motion_is_the_same() -> void:
	_start(-0.5, 0.55)
	_slide.move_to(0.7 * _slide.end_time)
	var time := _slide.end_time
	var place := Vec2.new(_slide.position_x, _slide.position_y)
	var velocity := _velocity(-0.5, 0.55)
	var start := _place(-0.5)
	var gravity := Vec2.new(0, _GRAVITY)
	for vector: Vec2 in [place, velocity, start, gravity]:
		vector.rotate_degrees(130.0)
	assert_no_refusal(
		_slide.start(7, -9, start.x + 7, start.y - 9, velocity.x, velocity.y, gravity.x, gravity.y)
	)
	_slide.move_to(0.7 * _slide.end_time)
	assert_almost_eq(_slide.end_time, time, 1e-13)
	assert_vec2(Vec2.new(_slide.position_x - 7, _slide.position_y + 9), place, 1e-12)


func test_the_time_to_a_direction_is_when_it_is_there() -> void:
	_start(-0.5, 0.6)
	for part: float in [0.0, 0.2, 0.6, 0.999]:
		_slide.move_to(part * _slide.end_time)
		var seconds := _slide.time_to_direction(_slide.position_x, _slide.position_y)
		assert_almost_eq(seconds, part * _slide.end_time, 1e-13)
	assert_eq(_slide.time_to_direction(1, 0), INF)
	assert_eq(_slide.time_to_direction(-1, -0.1), INF)


func test_a_centre_on_the_end_is_refused() -> void:
	_start(0.3, 0.0)
	var time := _slide.end_time
	var message := _slide.start(5, 6, 5, 6, 1, 0, 0, 10)
	assert_eq(message, "CapSlide.start: the centre must not be on the end itself, (5.0, 6.0).")
	assert_eq(_slide.end_time, time)


func _start_at(start: Array) -> void:
	var degrees: float = start[0]
	var speed: float = start[1]
	_start(deg_to_rad(degrees), speed)


func _start(angle: float, speed: float) -> void:
	var place := _place(angle)
	var velocity := _velocity(angle, speed)
	assert_no_refusal(_slide.start(0, 0, place.x, place.y, velocity.x, velocity.y, 0, _GRAVITY))


func _place(angle: float) -> Vec2:
	return Vec2.new(_RADIUS * sin(angle), -_RADIUS * cos(angle))


func _velocity(angle: float, speed: float) -> Vec2:
	var along := Vec2.new(cos(angle), sin(angle))
	return along.scaled(speed * sqrt(_GRAVITY * _RADIUS))


func _radians(start: Array) -> float:
	var degrees: float = start[0]
	return deg_to_rad(degrees)


func _angular_speed(start: Array) -> float:
	var speed: float = start[1]
	return speed * sqrt(_GRAVITY / _RADIUS)


func _energy() -> float:
	var squared := _slide.velocity_x ** 2 + _slide.velocity_y ** 2
	return 0.5 * squared - _GRAVITY * _slide.position_y


# Angle and angular speed by the classical method of Runge and Kutta, from a'' = g / R sin a alone.
func _stepped(angle: float, speed: float, seconds: float) -> PackedFloat64Array:
	var k := _GRAVITY / _RADIUS
	var h := seconds / _STEPS
	for _step: int in _STEPS:
		var pull_1 := k * sin(angle)
		var speed_2 := speed + 0.5 * h * pull_1
		var pull_2 := k * sin(angle + 0.5 * h * speed)
		var speed_3 := speed + 0.5 * h * pull_2
		var pull_3 := k * sin(angle + 0.5 * h * speed_2)
		var speed_4 := speed + h * pull_3
		var pull_4 := k * sin(angle + h * speed_3)
		angle += h / 6.0 * (speed + 2.0 * speed_2 + 2.0 * speed_3 + speed_4)
		speed += h / 6.0 * (pull_1 + 2.0 * pull_2 + 2.0 * pull_3 + pull_4)
	return [angle, speed]
