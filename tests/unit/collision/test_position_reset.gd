extends LabTest
## Position reset, part 12 of the lecture.

## Its normal is (0.6, -0.8), up and to the right.
var line := LineSegment.new(Vec2.new(60, 45), Vec2.new(-60, -45))


func test_the_ball_goes_back_along_the_normal() -> void:
	var ball := Ball.new(Vec2.new(6, 42), 10)
	PositionReset.reset(ball, line)
	assert_vec2(ball.position, Vec2.new(30, 10), 1e-13)


# Part 2 of the lecture moves the ball straight up: it would keep its x and come to (6, -8).
func test_it_does_not_go_straight_up() -> void:
	var ball := Ball.new(Vec2.new(6, 42), 10)
	PositionReset.reset(ball, line)
	assert_gt(ball.position.x, 29.0)


func test_afterwards_it_just_touches() -> void:
	for position: Vec2 in random_vectors(71, 200):
		var ball := Ball.new(position, 7)
		PositionReset.reset(ball, line)
		assert_almost_eq(LineDistance.signed_distance(ball.position, line), 7.0, 1e-12)


func test_its_place_along_the_line_stays() -> void:
	for position: Vec2 in random_vectors(72, 200):
		var ball := Ball.new(position, 7)
		PositionReset.reset(ball, line)
		assert_almost_eq(line.share_of(ball.position), line.share_of(position), 1e-14)


func test_a_second_reset_moves_nothing() -> void:
	var ball := Ball.new(Vec2.new(-3, 44), 10)
	PositionReset.reset(ball, line)
	var once := ball.position.copy()
	PositionReset.reset(ball, line)
	assert_vec2(ball.position, once, 1e-13)


func test_the_velocity_stays() -> void:
	var ball := Ball.new(Vec2.new(6, 42), 10, Vec2.new(3, 4))
	PositionReset.reset(ball, line)
	assert_vec2(ball.velocity, Vec2.new(3, 4), 0.0)
