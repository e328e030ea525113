extends LabTest
## Which balls are near a ball.

const _BALLS := 60
const _SIZE := 20.0


func test_crossing_a_border_is_the_same_as_entering_the_new_cell() -> void:
	var cells := BallCells.new()
	cells.lay_out(_SIZE, _BALLS)
	var places := random_vectors(5, _BALLS, 300.0)
	var velocities := random_vectors(6, _BALLS, 100.0)
	var wrong: PackedInt32Array = []
	for ball: int in _BALLS:
		cells.put(ball, places[ball].x, places[ball].y)
	for crossing: int in 20 * _BALLS:
		var ball := crossing % _BALLS
		var place := places[ball]
		var velocity := velocities[ball]
		var seconds := cells.time_to_leave(ball, place.x, place.y, velocity.x, velocity.y, 0.0, 0.0)
		cells.cross(ball)
		# Onto the border, and a little beyond it.
		place.add(velocity.scaled(seconds + 1e-9))
		var entered := BallCells.new()
		entered.lay_out(_SIZE, _BALLS)
		entered.put(ball, place.x, place.y)
		if entered.cell[ball] != cells.cell[ball]:
			wrong.append(crossing)
	assert_eq(wrong, PackedInt32Array())
	assert_eq(_listed(cells), _BALLS)


func test_a_removed_ball_is_in_no_list() -> void:
	var cells := BallCells.new()
	cells.lay_out(_SIZE, 3)
	for ball: int in 3:
		cells.put(ball, 5.0, 5.0)
	cells.remove(1)
	cells.remove(1)
	assert_eq(_listed(cells), 2)


func test_cells_hold_about_one_ball_and_the_largest_ball_fits() -> void:
	var places: PackedFloat64Array = [0, 0, 90, 0, 0, 90, 90, 90, 1e6, 1e6]
	var is_there: PackedByteArray = [1, 1, 1, 1, 0]
	var radii: PackedFloat64Array = [1, 2, 3, 4, 500]
	assert_eq(BallCells.size_for(places, radii, is_there), 45.0)
	radii[3] = 30.0
	assert_eq(BallCells.size_for(places, radii, is_there), 60.0)


# The number of balls in all lists together.
static func _listed(cells: BallCells) -> int:
	var count := 0
	for first in cells.first:
		var ball := first
		while ball >= 0:
			count += 1
			ball = cells.next[ball]
	return count
