extends LabTest
## When surfaces crush a ball: two that are opposite, and three around it.

var _ball := Ball.new(Vec2.new(0, 0), 10, Vec2.new(5, 3))


func test_two_opposite_surfaces_crush_when_the_way_between_them_is_gone() -> void:
	var squeeze := BallSqueeze.new(_ball)
	squeeze.add(Vec2.new(-14, 0), Vec2.new(2, 0))
	squeeze.add(Vec2.new(16, 0), Vec2.zero())
	squeeze.find(100.0, 1e-9)
	assert_almost_eq(squeeze.seconds, 5.0, 1e-14)
	# It keeps its velocity along them.
	assert_vec2(squeeze.velocity, Vec2.new((16.0 - 10.0) / 5.0, 3), 1e-14)


func test_what_parts_or_moves_along_crushes_nothing() -> void:
	for velocity: Vec2 in [Vec2.new(-2, 0), Vec2.zero(), Vec2.new(0, 9)]:
		var squeeze := BallSqueeze.new(_ball)
		squeeze.add(Vec2.new(-10, 0), velocity)
		squeeze.add(Vec2.new(10, 0), Vec2.zero())
		squeeze.find(100.0, 1e-9)
		assert_eq(squeeze.seconds, INF)


func test_what_touches_crushes_at_once_and_what_is_beyond_reach_never() -> void:
	var squeeze := BallSqueeze.new(_ball)
	squeeze.add(Vec2.new(-10, 0), Vec2.new(2, 0))
	squeeze.add(Vec2.new(10, 0), Vec2.zero())
	squeeze.find(1e-9, 1e-9)
	assert_eq(squeeze.seconds, 0.0)
	assert_vec2(squeeze.velocity, Vec2.new(5, 3), 0.0)
	squeeze = BallSqueeze.new(_ball)
	squeeze.add(Vec2.new(-10, 0), Vec2.new(2, 0))
	squeeze.add(Vec2.new(10.1, 0), Vec2.zero())
	squeeze.find(1e-9, 1e-9)
	assert_eq(squeeze.seconds, INF)


# Three walls at 120 degrees, each 6 px away, of which one comes nearer with 9 px/s: after 2 s their
# ways along the normals add up to nothing.
func test_three_surfaces_around_a_ball_crush_it() -> void:
	var squeeze := BallSqueeze.new(_ball)
	for number: int in 3:
		var outwards := Vec2.unit_radians(number * TAU / 3.0)
		var velocity := outwards.scaled(-9.0) if number == 0 else Vec2.zero()
		squeeze.add(outwards.scaled(16.0), velocity)
	squeeze.find(100.0, 1e-9)
	assert_almost_eq(squeeze.seconds, 2.0, 1e-12)
	# The two at rest are touched then.
	for number: int in [1, 2]:
		var outwards := Vec2.unit_radians(number * TAU / 3.0)
		assert_almost_eq(squeeze.velocity.scaled(2.0).dot(outwards), 6.0, 1e-11)


func test_three_surfaces_on_one_side_let_it_go() -> void:
	var squeeze := BallSqueeze.new(_ball)
	for angle: float in [-0.5, 0.0, 0.6]:
		squeeze.add(Vec2.unit_radians(angle).scaled(10.0), Vec2.new(-5, 0))
	squeeze.find(100.0, 1e-9)
	assert_eq(squeeze.seconds, INF)
