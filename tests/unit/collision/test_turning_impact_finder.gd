extends LabTest
## The first impact with a segment that turns, compared with a search in very small steps. The exact
## answers are in tests/unit/friction/test_friction_impact.gd.

const _SHOTS := 120
const _LONGEST := 3.0
const _LOOKS := 400

var _finder := TurningImpactFinder.new()


func test_nothing_is_touched_before_and_the_ball_touches_then() -> void:
	var hits := 0
	for shot in _shots():
		var is_hit := _finder.find(shot.ball, shot.turning, _LONGEST)
		var last := _finder.time if is_hit else _LONGEST
		assert_gt(shot.least_gap(last), -1e-9)
		if is_hit:
			hits += 1
			assert_almost_eq(shot.gap(last), 0.0, 1e-9)
	assert_between(hits, 40, _SHOTS - 20)


func test_normal_and_arm_are_those_of_that_moment() -> void:
	for shot in _shots():
		if not _finder.find(shot.ball, shot.turning, _LONGEST):
			continue
		var centre := shot.centre(_finder.time)
		var segment := shot.turning.segment_at(_finder.time)
		var touched := segment.closest_point(centre)
		var arm := touched.minus(shot.turning.pivot_at(_finder.time))
		assert_vec2(_finder.arm, arm, 1e-9)
		assert_vec2(_finder.normal, centre.minus(touched).normalized(), 1e-9)
		var is_end := _finder.feature != Impact.Feature.LINE
		var to_end := minf(touched.distance_to(segment.start), touched.distance_to(segment.end))
		assert_eq(is_end, to_end < 1e-9)


# Ten frames a second are too few for these paddles.
func test_in_frames_it_is_the_same_or_too_late_or_not_seen() -> void:
	var late := 0
	for shot in _shots():
		var is_hit := _finder.find(shot.ball, shot.turning, _LONGEST)
		var time := _finder.time
		var is_seen := _finder.find_by_frames(shot.ball, shot.turning, _LONGEST, 0.1)
		assert_true(is_hit or not is_seen)
		if is_seen and absf(_finder.time - time) < 1e-9:
			continue
		if is_seen:
			assert_gt(_finder.time, time)
		late += 1 if is_hit else 0
	assert_gt(late, 0)


func test_the_end_of_a_fast_paddle_passes_through_the_ball_between_two_frames() -> void:
	var paddle := TurningSegment.new(
		LineSegment.new(Vec2.zero(), Vec2.new(100, 0)), Vec2.zero(), 60
	)
	var ball := Ball.new(Vec2.new(0, 95), 2, Vec2.new(300, 0))
	assert_true(_finder.find(ball, paddle, 1.0))
	assert_lt(_finder.time, PI / 120.0)
	assert_eq(_finder.feature, Impact.Feature.LINE)
	assert_false(_finder.find_by_frames(ball, paddle, 1.0 / 30.0, 1.0 / 60.0))


func test_without_a_turn_it_is_the_straight_flight() -> void:
	var straight := StraightImpactFinder.new()
	for shot in _shots():
		shot.turning.turn = 0.0
		var segment := shot.turning.segment
		var velocity := shot.ball.velocity.minus(shot.turning.velocity)
		var is_hit := straight.with_segment(
			shot.ball.position.x,
			shot.ball.position.y,
			velocity.x,
			velocity.y,
			shot.ball.radius,
			segment.start.x,
			segment.start.y,
			segment.end.x,
			segment.end.y
		)
		is_hit = is_hit and straight.time <= _LONGEST
		assert_eq(_finder.find(shot.ball, shot.turning, _LONGEST), is_hit)
		if is_hit:
			assert_almost_eq(_finder.time, straight.time, 1e-12)


func test_a_ball_at_rest_is_met_within_a_turn_or_never() -> void:
	var paddle := TurningSegment.new(
		LineSegment.new(Vec2.new(50, 0), Vec2.new(100, 0)), Vec2.zero(), 1e-3
	)
	assert_true(_finder.find(Ball.new(Vec2.new(0, -80), 5), paddle, 1e9))
	assert_between(_finder.time, 4500.0, TAU * 1e3)
	for place: float in [0.0, 40.0, 106.0]:
		assert_false(_finder.find(Ball.new(Vec2.new(0, -place), 5), paddle, 1e9))


func test_a_slow_ball_within_a_fast_ring_is_followed_in_few_looks() -> void:
	var paddle := TurningSegment.new(
		LineSegment.new(Vec2.new(50, 0), Vec2.new(100, 0)), Vec2.zero(), 100.0
	)
	var ball := Ball.new(Vec2.zero(), 5, Vec2.new(1e-6, 0))
	assert_true(_finder.find(ball, paddle, 1e9))
	assert_almost_eq(_finder.time, 45e6, 1e3)


func test_a_ball_from_far_away_is_met_where_the_paddle_turns() -> void:
	var paddle := TurningSegment.new(
		LineSegment.new(Vec2.new(-100, 0), Vec2.new(100, 0)), Vec2.zero(), 50.0
	)
	assert_true(_finder.find(Ball.new(Vec2.new(-1e9, 0), 5, Vec2.new(1000, 0)), paddle, 1e9))
	assert_between(_finder.time, 1e6 - 0.105, 1e6)
	assert_false(_finder.find(Ball.new(Vec2.new(-1e9, 106), 5, Vec2.new(1000, 0)), paddle, 1e9))


func test_a_centre_on_the_line_is_met_from_the_side_it_comes_from() -> void:
	for turn: float in [1.0, -1.0]:
		var paddle := TurningSegment.new(
			LineSegment.new(Vec2.zero(), Vec2.new(100, 0)), Vec2.zero(), turn
		)
		assert_true(_finder.find(Ball.new(Vec2.new(50, 0), 5), paddle, 1.0))
		assert_eq(_finder.time, 0.0)
		assert_vec2(_finder.normal, Vec2.new(0, turn), 0.0)


# Rounding decides whether such a centre is beside the line, which has a side, or beyond the end.
func test_a_centre_on_an_end_has_a_normal_or_no_impact() -> void:
	var vectors := random_vectors(32, 300)
	var misses := 0
	for index: int in range(0, vectors.size(), 3):
		var segment := LineSegment.new(vectors[index], vectors[index + 1])
		var paddle := TurningSegment.new(segment, Vec2.zero(), 1.0)
		var ball := Ball.new(segment.end, 5, vectors[index + 2])
		if _finder.find(ball, paddle, 1.0):
			assert_almost_eq(_finder.normal.length(), 1.0, 1e-15)
		else:
			misses += 1
	assert_between(misses, 1, 60)


func test_a_ball_that_overlaps_and_moves_away_is_not_held_but_met_again() -> void:
	var paddle := TurningSegment.new(
		LineSegment.new(Vec2.zero(), Vec2.new(100, 0)), Vec2.zero(), 1.0
	)
	# The paddle turns away from the ball, all round, and comes from the other side.
	var ball := Ball.new(Vec2.new(80, -4), 5)
	assert_true(_finder.find(ball, paddle, 10.0))
	assert_between(_finder.time, 6.0, TAU)
	# Turned the other way round it pushes the ball at once.
	paddle.turn = -1.0
	assert_true(_finder.find(ball, paddle, 10.0))
	assert_eq(_finder.time, 0.0)


func test_what_cannot_be_used_is_an_error() -> void:
	var paddle := TurningSegment.new(
		LineSegment.new(Vec2.zero(), Vec2.new(100, 0)), Vec2.zero(), 1.0
	)
	var ball := Ball.new(Vec2.new(80, -40), 5)
	for bad: float in [INF, NAN, -1.0]:
		assert_false(_finder.find(ball, paddle, bad))
		assert_push_error("The search must take 0 s or more and end, not take %s s." % bad)
	assert_false(_finder.find_by_frames(ball, paddle, 1.0, 0.0))
	assert_push_error("A frame must take more than 0 s, not 0.0 s.")
	paddle.turn = NAN
	assert_false(_finder.find(ball, paddle, 1.0))
	assert_push_error("A segment must turn by -1e+70..1e+70 rad/s, not by nan.")
	ball.radius = -1.0
	assert_false(_finder.find(ball, paddle, 1.0))
	assert_push_error("A ball's radius must be above 0")


static func _shots() -> Array[PaddleShot]:
	var rng := RandomNumberGenerator.new()
	rng.seed = 31
	var shots: Array[PaddleShot] = []
	while shots.size() < _SHOTS:
		var shot := PaddleShot.new(rng)
		if shot.gap(0.0) > 0.01:
			shots.append(shot)
	return shots


class PaddleShot:
	var ball: Ball
	var turning: TurningSegment

	func _init(rng: RandomNumberGenerator) -> void:
		var start := _place(rng, 100)
		var segment := LineSegment.new(start, start.plus(_place(rng, 150)))
		var turn := rng.randf_range(-12, 12)
		turning = TurningSegment.new(segment, _place(rng, 100), turn, _place(rng, 60))
		ball = Ball.new(_place(rng, 300), rng.randf_range(1, 30), _place(rng, 200))

	func centre(time: float) -> Vec2:
		return ball.position.plus(ball.velocity.scaled(time))

	func gap(time: float) -> float:
		var place := centre(time)
		var nearest := turning.segment_at(time).closest_point(place)
		return nearest.distance_to(place) - ball.radius

	func least_gap(last: float) -> float:
		var least := INF
		for look: int in _LOOKS:
			least = minf(least, gap(last * look / _LOOKS))
		return least

	static func _place(rng: RandomNumberGenerator, farthest: float) -> Vec2:
		return Vec2.random_unit(rng).scaled(rng.randf_range(0, farthest))
