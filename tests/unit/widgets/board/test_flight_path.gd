extends LabTest
## The way of a shot with its dots.


func test_there_is_a_place_after_each_equal_piece_of_time() -> void:
	var found := FlightPath.places_every(0.25, 1.0, _place_after)
	assert_eq(found.map(func(at: Vec2) -> float: return at.x), [0.0, 25.0, 50.0, 75.0, 100.0])


# 0.1 is no double: three of it are more than 0.3.
func test_rounding_costs_no_place() -> void:
	assert_eq(FlightPath.places_every(0.1, 0.3, _place_after).size(), 4)


func test_a_way_without_end_is_cut() -> void:
	assert_eq(FlightPath.places_every(0.1, INF, _place_after, 7).size(), 7)
	assert_eq(FlightPath.places_every(0.1, NAN, _place_after).size(), 0)


func test_the_way_keeps_all_digits() -> void:
	var path := FlightPath.new()
	add_child_autofree(path)
	path.show_path([Vec2.new(0.1, 0.2), Vec2.new(0.3, 1.0 / 3.0)])
	assert_eq(path.spanned_points()[1].y, 1.0 / 3.0)
	assert_eq(path.places.size(), 2)


func _place_after(seconds: float) -> Vec2:
	return Vec2.new(100.0 * seconds, 0.0)
