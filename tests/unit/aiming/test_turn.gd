extends LabTest
## Directions as angles: looking at a target, and turning to it the short way.

const _CLOSE := 1e-14


func test_the_angle_of_a_target_is_clockwise_from_the_x_axis() -> void:
	var from := Vec2.new(10, 20)
	assert_eq(Turn.toward(from, Vec2.new(15, 20)), 0.0)
	assert_almost_eq(Turn.toward(from, Vec2.new(10, 25)), PI / 2, _CLOSE)
	assert_eq(Turn.toward(from, from), 0.0)


func test_a_barrel_on_a_hull_is_turned_by_what_the_hull_is_not() -> void:
	assert_almost_eq(Turn.on_mount(_rad(90), _rad(30)), _rad(60), _CLOSE)


func test_the_short_way_goes_past_half_a_turn() -> void:
	assert_almost_eq(Turn.shortest(_rad(170), _rad(-170)), _rad(20), 1e-12)
	assert_almost_eq(Turn.shortest(_rad(-170), _rad(170)), _rad(-20), 1e-12)
	assert_eq(Turn.shortest(0, PI), PI)
	for turns: int in [-3, -1, 2]:
		assert_almost_eq(Turn.shortest(0.5, 1.0 + turns * TAU), 0.5, 1e-14 * TAU * 3)


func test_a_step_stops_at_the_target() -> void:
	assert_almost_eq(Turn.stepped(_rad(170), _rad(-170), _rad(5)), _rad(175), 1e-12)
	assert_almost_eq(Turn.stepped(0, 0.25, 1.0), 0.25, _CLOSE)


func test_easing_does_not_depend_on_the_frame_rate() -> void:
	var once := Turn.eased(_rad(170), _rad(-170), 0.1, 0.1)
	assert_almost_eq(Turn.shortest(once, _rad(-170)), _rad(10), 1e-12)
	var angle := _rad(170)
	for frame: int in 60:
		angle = Turn.eased(angle, _rad(-170), 0.1, 0.1 / 60)
	assert_almost_eq(Turn.shortest(angle, once), 0.0, 1e-12)


static func _rad(degrees: float) -> float:
	return Vec2.deg_to_rad(degrees)
