extends LabTest
## The law of reflection with a bounciness.


func test_the_reflection_of_the_lecture() -> void:
	var velocity := Vec2.new(3, 4)
	velocity.reflect(Vec2.new(0, -1))
	assert_vec2(velocity, Vec2.new(3, -4), 0.0)


func test_bounciness_acts_along_the_normal_only() -> void:
	assert_vec2(Vec2.new(3, 4).reflected(Vec2.new(0, -1), 0.5), Vec2.new(3, -2), 0.0)


func test_without_bounciness_the_velocity_slides_along_the_line() -> void:
	assert_vec2(Vec2.new(3, 4).reflected(Vec2.new(0, -1), 0), Vec2.new(3, 0), 0.0)


func test_an_angled_line_turns_the_velocity_as_the_mirror_does() -> void:
	# A line at 45 degrees swaps the components.
	var velocity := Vec2.new(5, 0).reflected(Vec2.new(1, 1).normal())
	assert_vec2(velocity, Vec2.new(0, 5), 2e-15)


func test_both_normals_of_a_line_give_the_same() -> void:
	for velocity: Vec2 in random_vectors(41, 20):
		var normal := Vec2.new(2, 5).normal()
		assert_vec2(velocity.reflected(normal, 0.7), velocity.reflected(normal.negated(), 0.7), 0.0)


func test_reflecting_twice_gives_the_velocity_back() -> void:
	# Twice is I + 4 (n.n - 1) n n^T; a normal within 1.5 units of length 1 leaves at most 12 of
	# them.
	for velocity: Vec2 in random_vectors(42, 100):
		var normal := Vec2.new(velocity.y, 3.0).normal()
		var allowed := 12.0 * EPSILON * velocity.length()
		assert_vec2(velocity.reflected(normal).reflected(normal), velocity, allowed)


func test_full_bounciness_keeps_the_speed() -> void:
	var changes := PackedFloat64Array()
	var vectors := random_vectors(43, 200)
	for index: int in range(0, 200, 2):
		var velocity := vectors[index]
		var after := velocity.reflected(vectors[index + 1].normal())
		changes.append(absf(after.length() / velocity.length() - 1.0))
	assert_all_at_most(changes, 6.0 * EPSILON)


func test_the_speed_along_the_normal_is_turned_and_scaled_and_the_other_kept() -> void:
	var vectors := random_vectors(44, 100)
	for index: int in range(0, 100, 2):
		var velocity := vectors[index]
		var normal := vectors[index + 1].normal()
		var after := velocity.reflected(normal, 0.3)
		assert_almost_eq(after.dot(normal), -0.3 * velocity.dot(normal), 1e-13)
		assert_almost_eq(after.cross(normal), velocity.cross(normal), 1e-13)


func test_reflect_and_reflected_agree() -> void:
	for velocity: Vec2 in random_vectors(45, 20):
		var normal := Vec2.unit_degrees(33)
		var changed := velocity.copy()
		changed.reflect(normal, 0.25)
		assert_vec2(velocity.reflected(normal, 0.25), changed, 0.0)


func test_a_normal_that_is_not_unit_is_refused() -> void:
	var velocity := Vec2.new(3, 4)
	for wrong: Vec2 in [Vec2.new(0, 2), Vec2.zero(), Vec2.new(0, NAN), Vec2.new(INF, 0)]:
		velocity.reflect(wrong)
		assert_vec2(velocity, Vec2.new(3, 4), 0.0)
		assert_push_error("must have length 1, but has length %s." % wrong.length())


func test_reflected_by_a_normal_that_is_not_unit_is_a_copy() -> void:
	assert_vec2(Vec2.new(3, 4).reflected(Vec2.new(0, 2)), Vec2.new(3, 4), 0.0)
	assert_push_error("Vec2.reflect: the normal must have length 1, but has length 2.0.")


func test_a_normal_may_be_off_by_a_billionth() -> void:
	assert_vec2(Vec2.new(3, 4).reflected(Vec2.new(0, 1.0 + 0.9e-9)), Vec2.new(3, -4), 2e-8)
	assert_vec2(Vec2.new(3, 4).reflected(Vec2.new(0, 1.0 - 0.9e-9)), Vec2.new(3, -4), 2e-8)


func test_a_normal_off_by_more_is_refused_and_the_length_told() -> void:
	assert_vec2(Vec2.new(3, 4).reflected(Vec2.new(0, 1.0 + 2e-9)), Vec2.new(3, 4), 0.0)
	assert_push_error("length 1.000000002.")


func test_a_bounciness_outside_0_to_1_is_refused() -> void:
	var velocity := Vec2.new(3, 4)
	for wrong: float in [-0.1, -1e-9, 1.000001, 1.5, NAN, INF]:
		velocity.reflect(Vec2.new(0, 1), wrong)
		assert_vec2(velocity, Vec2.new(3, 4), 0.0)
		assert_push_error("must be within 0..1, but is %s." % wrong)
