extends LabTest
## The law of reflection with a bounciness, and when it is applied.


func test_the_bounce_of_the_lecture() -> void:
	assert_vec2(_bounced(Vec2.new(3, 4), Vec2.new(0, -1)), Vec2.new(3, -4), 0.0)


func test_half_the_bounciness_gives_half_the_speed_back() -> void:
	assert_vec2(_bounced(Vec2.new(3, 4), Vec2.new(0, -1), 0.5), Vec2.new(3, -2), 0.0)


func test_without_bounciness_the_ball_slides() -> void:
	assert_vec2(_bounced(Vec2.new(3, 4), Vec2.new(0, -1), 0.0), Vec2.new(3, 0), 0.0)


func test_a_velocity_against_the_normal_approaches() -> void:
	assert_true(Bounce.is_approaching(Vec2.new(3, 4), Vec2.new(0, -1)))
	assert_false(Bounce.is_approaching(Vec2.new(3, -4), Vec2.new(0, -1)))


func test_a_velocity_along_the_line_does_not_approach() -> void:
	assert_false(Bounce.is_approaching(Vec2.new(3, 0), Vec2.new(0, -1)))


func test_the_direction_is_mirrored_at_the_line() -> void:
	# In angles: a line at the angle l turns the direction d into 2 l - d.
	var vectors := random_vectors(141, 200)
	for i: int in range(0, 200, 2):
		var along := vectors[i + 1]
		var got := _bounced_approaching(vectors[i], along, 1.0)
		var angle := 2.0 * along.angle_radians() - vectors[i].angle_radians()
		var wanted := Vec2.unit_radians(angle).scaled(vectors[i].length())
		assert_vec2(got, wanted, 1e-12)


func test_bouncing_back_from_the_other_side_gives_the_velocity_back() -> void:
	var vectors := random_vectors(142, 200)
	for i: int in range(0, 200, 2):
		var velocity := vectors[i].copy()
		var normal := _facing_normal(velocity, vectors[i + 1])
		Bounce.apply(velocity, normal)
		Bounce.apply(velocity, normal.negated())
		assert_vec2(velocity, vectors[i], 1e-12)


func test_the_part_along_the_line_is_unchanged() -> void:
	var changes := PackedFloat64Array()
	var vectors := random_vectors(143, 200)
	for i: int in range(0, 200, 2):
		var along := vectors[i + 1]
		var got := _bounced_approaching(vectors[i], along, 0.3)
		changes.append(absf(got.scalar_projection(along) - vectors[i].scalar_projection(along)))
	assert_all_at_most(changes, 1e-12)


func test_the_energy_that_is_lost_is_that_along_the_normal() -> void:
	# v'^2 = t^2 + C^2 m^2 with the parts t along the line and m along the normal: v^2 = t^2 + m^2.
	var errors := PackedFloat64Array()
	var vectors := random_vectors(144, 200)
	for i: int in range(0, 200, 2):
		var along := vectors[i + 1]
		var squared_tangent := vectors[i].scalar_projection(along) ** 2.0
		var squared_normal := vectors[i].length_squared() - squared_tangent
		var got := _bounced_approaching(vectors[i], along, 0.6)
		errors.append(absf(got.length_squared() - squared_tangent - 0.36 * squared_normal))
	assert_all_at_most(errors, 1e-10)


func test_full_bounciness_keeps_the_energy_of_a_hundred_bounces() -> void:
	var velocity := Vec2.new(3, 4)
	for along: Vec2 in random_vectors(145, 100):
		Bounce.apply(velocity, _facing_normal(velocity, along))
	assert_almost_eq(velocity.length(), 5.0, 1e-12)


func test_mistake_11_a_normal_that_is_not_unit_is_refused() -> void:
	# If this normal were used as it is, the result would be (3, -28).
	assert_vec2(_bounced(Vec2.new(3, 4), Vec2.new(0, -2)), Vec2.new(3, 4), 0.0)
	assert_push_error("Vec2.reflect: the normal must have length 1, but has length 2.0.")


func test_mistake_12_the_normal_of_the_normal_is_not_used() -> void:
	# With the normal of the normal the result would be (-3, 4), which leads into the line.
	var velocity := _bounced(Vec2.new(3, 4), Vec2.new(0, -1))
	assert_gt(velocity.dot(Vec2.new(0, -1)), 0.0, "it moves away from the line")
	assert_eq(velocity.x, 3.0, "it keeps its velocity along the line")


func test_mistake_13_bounciness_leaves_the_tangent_alone() -> void:
	# If bounciness acted on the tangent, the result would be (1.5, -4).
	var velocity := _bounced(Vec2.new(3, 4), Vec2.new(0, -1), 0.5)
	assert_eq(velocity.x, 3.0)
	assert_eq(velocity.y, -2.0)


func test_mistake_14_a_ball_that_moves_away_is_left_alone() -> void:
	# It still overlaps the line in the frames after the bounce.
	var velocity := Vec2.new(3, 4)
	for frame: int in 10:
		Bounce.apply(velocity, Vec2.new(0, -1))
		assert_vec2(velocity, Vec2.new(3, -4), 0.0, "frame %d" % frame)


func test_a_bounciness_within_0_and_1_has_no_problem() -> void:
	for good: float in [0.0, 0.5, 1.0]:
		assert_eq(Bounce.problem_of_bounciness(good), "")


func test_another_bounciness_is_named_with_what_is_allowed() -> void:
	for bad: float in [-0.1, 1.5, INF, NAN]:
		assert_eq(
			Bounce.problem_of_bounciness(bad), "The bounciness C must be within 0..1, not %s." % bad
		)


func _bounced(velocity: Vec2, normal: Vec2, bounciness: float = 1.0) -> Vec2:
	var result := velocity.copy()
	Bounce.apply(result, normal, bounciness)
	return result


func _bounced_approaching(velocity: Vec2, along: Vec2, bounciness: float) -> Vec2:
	return _bounced(velocity, _facing_normal(velocity, along), bounciness)


# The normal of a line along `along` on the side from which `velocity` comes.
func _facing_normal(velocity: Vec2, along: Vec2) -> Vec2:
	var normal := along.normal()
	return normal.negated() if velocity.dot(normal) > 0.0 else normal
