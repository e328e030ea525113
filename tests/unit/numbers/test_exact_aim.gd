extends LabTest
## The error of a computed time of flight, where the exact time is known.

const _DOWN := 300.0


func test_an_exact_time_has_no_error() -> void:
	assert_eq(_error(1.0), 0.0)


func test_a_late_time_is_too_large_by_so_much() -> void:
	for off: float in [1e-12, 1e-6, -1e-6, 1e-3]:
		assert_almost_eq(_error(1.0 + off), off, 1e-3 * absf(off) + 1e-16)


func test_one_unit_in_the_last_place_is_seen() -> void:
	assert_almost_eq(_error(1.0 + 2.0 ** -52), 2.0 ** -52, 2.0 ** -60)


func test_at_the_edge_where_both_times_are_one() -> void:
	var way := Vec2.new(80, -60)
	var time := BallisticAim.fixed_times(way, Vec2.new(0, 250), 200.0)[0]
	var error := ExactAim.error_of_time(time, way, Vec2.zero(), Vec2.new(0, -250), 200.0)
	assert_lt(absf(error), 1e-7)


func test_discs_touch_earlier() -> void:
	var way := Vec2.new(110, 0)
	var error := ExactAim.error_of_time(1.0, way, Vec2.zero(), Vec2.zero(), 100.0, 10.0)
	assert_eq(error, 0.0)


# Of the flat arc to (200, 0), which hits after 1 s.
func _error(time: float) -> float:
	var bend := Vec2.new(0, -_DOWN)
	return ExactAim.error_of_time(time, Vec2.new(200, 0), Vec2.zero(), bend, 250.0)
