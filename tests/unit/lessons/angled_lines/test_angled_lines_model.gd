extends LabTest
## Tests of the lesson on angled lines: presets, mistakes, past, what is entered, questions.


func test_every_preset_has_balls_inside_and_lines() -> void:
	for preset: int in AngledLinesPresets.TITLES.size():
		var model := AngledLinesModel.new()
		model.set_up(preset)
		var world := model.world
		assert_gt(world.surroundings.segments.size(), 3, AngledLinesPresets.TITLES[preset])
		assert_eq(world.lost_count(), 0)


func test_the_first_preset_is_the_world_that_the_lesson_has_at_the_start() -> void:
	var first := AngledLinesPresets.world_of(9)
	assert_no_refusal(first.surroundings.set_bounciness(0.25))
	var model := AngledLinesModel.new(first)
	assert_eq(model.world.surroundings.bounciness, 0.25)
	model.step()
	model.set_up(5)
	var linked := model.link_state()
	model.set_up(0)
	assert_eq(WorldState.of(model.world), WorldState.of(first))
	var kept_bounciness: float = model.link_base(linked, {"scene": 0})["bounciness"]
	assert_eq(kept_bounciness, 0.25)
	assert_no_refusal(model.set_bounciness(1.0))
	var again := AngledLinesModel.new()
	again.from_dictionary(model.reset_state({}))
	assert_eq(WorldState.of(again.world), WorldState.of(first))


func test_one_ten_and_fifty_balls_are_among_the_presets() -> void:
	var counts: Array[int] = []
	for preset: int in [0, 7, 8]:
		var model := AngledLinesModel.new()
		model.set_up(preset)
		counts.append(model.world.balls.size())
	assert_eq(counts, [1, 10, 50] as Array[int])


func test_in_no_preset_a_ball_overlaps_a_line_at_the_start() -> void:
	for preset: int in AngledLinesPresets.TITLES.size():
		var model := AngledLinesModel.new()
		model.set_up(preset)
		var deepest := INF
		for ball: Ball in model.world.balls:
			for line: LineSegment in model.world.surroundings.segments:
				var gap := line.closest_point(ball.position).distance_to(ball.position)
				deepest = minf(deepest, gap - ball.radius)
		assert_gt(deepest, -1e-9, AngledLinesPresets.TITLES[preset])


# Week 4 comes with position reset, which keeps no energy.
func test_no_ball_is_lost_and_no_energy_in_ten_seconds_of_any_preset() -> void:
	for preset: int in AngledLinesPresets.WEEK_4:
		var model := AngledLinesModel.new()
		model.set_up(preset)
		for frame: int in 600 if preset != 8 else 120:
			model.step()
		assert_eq(model.world.losses, 0, AngledLinesPresets.TITLES[preset])
		if model.world.surroundings.bounciness == 1.0:
			assert_almost_eq(model.energy_share(model.world), 1.0, 1e-9)


func test_once_a_second_all_balls_of_the_cradle_are_back() -> void:
	var model := AngledLinesModel.new()
	model.set_up(4)
	var before := model.world.balls[4].position.copy()
	for frame: int in 60 * 5:
		model.step()
	assert_vec2(model.world.balls[4].position, before, 1e-6)


func test_position_reset_loses_the_ball_of_the_tunnelling_preset() -> void:
	var model := AngledLinesModel.new()
	model.set_up(5)
	assert_eq(model.set_method(SteppingMethods.Method.POSITION_RESET), "")
	for frame: int in 60:
		model.step()
	assert_eq(model.world.lost_count(), 1)
	model.fetch_balls()
	assert_eq(model.world.lost_count(), 0)
	assert_vec2(model.ball().position, Vec2.new(-150.0, -5.0), 0.0)


func test_every_mistake_moves_a_ball_elsewhere_within_three_seconds() -> void:
	for mistake: MistakeInfo in AngledLinesMistakes.all():
		var model := AngledLinesModel.new()
		model.set_mistake(mistake.number)
		var apart := 0.0
		for frame: int in 180:
			model.step()
			apart = maxf(
				apart, model.ball().position.distance_to(model.wrong_world.balls[0].position)
			)
		assert_gt(apart, 1.0, "mistake %d" % mistake.number)


func test_full_gravity_before_the_bounce_gains_energy() -> void:
	var model := AngledLinesModel.new()
	model.set_mistake(26)
	for frame: int in 3600:
		model.step()
	assert_almost_eq(model.energy_share(model.world), 1.0, 1e-9)
	assert_gt(model.energy_share(model.wrong_world), 1.1)


func test_every_named_test_exists() -> void:
	for mistake: MistakeInfo in AngledLinesMistakes.all():
		var parts := mistake.test.split(".")
		var path := "res://tests/unit/world/stepped/%s.gd" % parts[0]
		var code := FileAccess.get_file_as_string(path)
		assert_string_contains(code, "func %s()" % parts[1])


func test_steps_back_undo_steps_with_a_mistake_on() -> void:
	var model := AngledLinesModel.new()
	model.set_mistake(24)
	var first := model.world.state()
	var first_wrong := model.wrong_world.state()
	for frame: int in 700:
		model.step()
	for frame: int in 700:
		model.step_back()
	assert_eq(model.world.state(), first)
	assert_eq(model.wrong_world.state(), first_wrong)
	assert_false(model.step_back())


func test_a_stored_model_put_back_runs_on_the_same() -> void:
	var model := AngledLinesModel.new()
	model.set_up(7)
	for frame: int in 50:
		model.step()
	var other := AngledLinesModel.new()
	other.from_dictionary(model.to_dictionary())
	for frame: int in 50:
		model.step()
		other.step()
	assert_eq(other.world.state(), model.world.state())
	assert_eq(other.preset, 7)


func test_arrow_keys_keep_the_strength_of_gravity() -> void:
	var model := AngledLinesModel.new()
	assert_eq(model.set_gravity(Vec2.new(30.0, 40.0)), "")
	assert_eq(model.point_gravity(Vec2.new(-1.0, 0.0)), "")
	assert_vec2(model.world.surroundings.gravity, Vec2.new(-50.0, 0.0), 1e-12)
	assert_eq(model.point_gravity(Vec2.new()), "")
	assert_eq(model.point_gravity(Vec2.new(0.0, -1.0)), "")
	assert_vec2(model.world.surroundings.gravity, Vec2.new(0.0, -300.0), 1e-12)


func test_gravity_too_strong_for_one_axis_is_refused() -> void:
	var model := AngledLinesModel.new()
	assert_eq(model.set_gravity(Vec2.new(1e6, 1e6)), "")
	assert_string_contains(model.point_gravity(Vec2.new(1.0, 0.0)), "Gravity must be within")
	assert_vec2(model.world.surroundings.gravity, Vec2.new(1e6, 1e6), 0.0)


func test_a_jammed_ball_is_told_by_the_step_and_by_the_comparison() -> void:
	var model := AngledLinesModel.new()
	model.put_up(_jammed())
	var comparison := MethodComparison.new()
	comparison.begin(model.world)
	while comparison.advance(100_000, AngledLinesModel.FRAME):
		pass
	model.step()
	assert_eq(model.refusal + comparison.refusal(SteppingMethods.Method.WHOLE_FRAME), "")
	assert_eq(model.set_method(SteppingMethods.Method.EVENT_WORLD), "")
	model.step()
	var exact := SteppingMethods.Method.EVENT_WORLD
	for sentence: String in [model.refusal, comparison.refusal(exact)]:
		assert_string_contains(sentence, "impacts within a second")
	assert_eq(AngledLinesTexts.comparison(comparison, exact)[1], "stopped")


func test_typed_numbers_arrive_and_wrong_ones_are_refused() -> void:
	var model := AngledLinesModel.new()
	assert_eq(AngledLinesFormula.enter(model, "vy", -55.5), "")
	assert_vec2(model.ball().velocity, Vec2.new(160.0, -55.5), 0.0)
	assert_eq(AngledLinesFormula.enter(model, "gx", 12.0), "")
	assert_vec2(model.world.surroundings.gravity, Vec2.new(12.0, 300.0), 0.0)
	assert_string_contains(AngledLinesFormula.enter(model, "C", 1.5), "0..1, not 1.5")
	assert_string_contains(AngledLinesFormula.enter(model, "px", 5000.0), "-800..800")
	assert_eq(model.world.surroundings.bounciness, 1.0)


func test_there_is_room_for_sixty_lines_only() -> void:
	var model := AngledLinesModel.new()
	var lines := model.lines()
	while lines.size() < AngledLinesLink.MOST_LINES + 1:
		lines.append(LineSegment.new(Vec2.new(), Vec2.new(5.0, 5.0)))
	assert_string_contains(model.set_lines(lines), "room for 60 lines")
	assert_eq(model.lines().size(), 10)


func test_the_forecast_is_what_happens() -> void:
	var model := AngledLinesModel.new()
	model.set_up(7)
	model.selected = 3
	var forecast := model.forecast(model.world)
	while model.last_bounce == null:
		model.step()
	assert_vec2(forecast.next_bounce.position, model.last_bounce.position, 0.0)


func test_no_energy_is_told_where_there_is_none_or_a_ball_took_it_along() -> void:
	var model := AngledLinesModel.new()
	model.set_up(5)
	assert_eq(model.set_method(SteppingMethods.Method.POSITION_RESET), "")
	for frame: int in 60:
		model.step()
	assert_true(is_nan(model.energy_share(model.world)), "lost")
	assert_no_refusal(model.set_gravity(Vec2.new()))
	model.fetch_balls()
	assert_no_refusal(model.change_ball(Vec2.new(), Vec2.new()))
	assert_true(is_nan(model.energy_share(model.world)), "no energy at the start")


func test_a_lost_ball_has_no_error_and_energy_from_nothing_is_marked() -> void:
	var model := AngledLinesModel.new()
	model.set_up(5)
	var row := _row_after(model.world, 60, SteppingMethods.Method.POSITION_RESET)
	assert_eq([row[1], row[2]], ["1 lost", "–"])
	model.set_up(3)
	row = _row_after(model.world, 600, SteppingMethods.Method.POINT_OF_IMPACT)
	assert_string_contains(row[1], "> 1")
	assert_string_contains(row[2], "≥ ")
	row = _row_after(model.world, 600, SteppingMethods.Method.WHOLE_FRAME)
	assert_eq(row[2], "–", "with C = 0.5 energy must be lost")


func test_a_mistake_is_not_shown_beside_the_way_that_makes_it() -> void:
	var model := AngledLinesModel.new()
	model.set_mistake(24)
	assert_eq(model.set_method(SteppingMethods.Method.POINT_OF_IMPACT), "")
	assert_eq(model.mistake, 0)
	assert_null(model.wrong_world)
	assert_eq(model.set_method(SteppingMethods.Method.WHOLE_FRAME), "")
	model.set_mistake(26)
	assert_eq(model.set_method(SteppingMethods.Method.POINT_OF_IMPACT), "")
	assert_eq(model.mistake, 26)


func test_a_ball_put_outside_of_all_lines_is_brought_back_to_where_it_began() -> void:
	var model := AngledLinesModel.new()
	assert_no_refusal(model.move_ball(Vec2.new(-100.0, -50.0)))
	assert_no_refusal(model.move_ball(Vec2.new(500.0, 0.0)))
	while model.world.lost_count() == 0:
		model.step()
	model.fetch_balls()
	assert_vec2(model.ball().position, Vec2.new(-100.0, -50.0), 0.0)


func test_every_mistake_says_in_words_what_its_test_checks() -> void:
	for mistake: MistakeInfo in AngledLinesMistakes.all():
		assert_true(mistake.checks.ends_with("."), mistake.title)


func test_the_comparison_shows_what_each_way_loses_in_a_minute() -> void:
	var model := AngledLinesModel.new()
	model.set_up(9)
	var comparison := MethodComparison.new()
	comparison.begin(model.world)
	while comparison.advance(100_000, AngledLinesModel.FRAME):
		pass
	assert_gt(comparison.energy_share(SteppingMethods.Method.POSITION_RESET), 1.05)
	assert_lt(comparison.energy_share(SteppingMethods.Method.POINT_OF_IMPACT), 0.95)
	assert_almost_eq(comparison.energy_share(SteppingMethods.Method.WHOLE_FRAME), 1.0, 1e-9)


func test_the_right_answers_of_questions_are_what_the_world_does() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 11
	for round_number: int in 20:
		var earliest := SteppingExercise.fresh(SteppingExercise.Kind.EARLIEST, rng)
		assert_no_refusal(earliest.world.step(AngledLinesModel.FRAME))
		var place := earliest.world.latest_bounces[0].position
		assert_true(earliest.check([place.x, place.y]).is_right)
		var rest := SteppingExercise.fresh(SteppingExercise.Kind.REST, rng)
		assert_no_refusal(rest.world.step(AngledLinesModel.FRAME))
		assert_true(rest.check([-rest.world.balls[0].position.y]).is_right)


func test_the_velocities_asked_for_are_what_the_world_does() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 12
	for round_number: int in 20:
		var away := SteppingExercise.fresh(SteppingExercise.Kind.MOVING_AWAY, rng)
		assert_no_refusal(away.world.step(AngledLinesModel.FRAME))
		var velocity := away.world.balls[0].velocity
		assert_true(away.check([velocity.x, velocity.y]).is_right, away.prompt)
		var gravity := SteppingExercise.fresh(SteppingExercise.Kind.GRAVITY, rng)
		assert_no_refusal(gravity.world.step(AngledLinesModel.FRAME))
		var speed := gravity.world.latest_bounces[0].velocity_before.y
		# Within the frame the world takes the way as straight: that is worth up to 0.07 px/s.
		assert_almost_eq(gravity.right_answer[0], speed, 0.07, gravity.prompt)


func test_every_question_tells_its_mistakes_apart() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 14
	var unclear: PackedStringArray = []
	for kind: int in SteppingExercise.Kind.size():
		for question: int in 500:
			var exercise := Exercise.drawn(SteppingExercise.fresh, kind, rng)
			if not exercise.tells_mistakes_apart():
				unclear.append(exercise.prompt)
	assert_eq(unclear, PackedStringArray())


func test_wrong_answers_are_named() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 13
	for kind: int in SteppingExercise.Kind.size():
		var exercise := Exercise.drawn(SteppingExercise.fresh, kind, rng)
		assert_gt(exercise.mistakes.size(), 0)
		for mistake: Exercise.Mistake in exercise.mistakes:
			assert_eq(exercise.check(mistake.answer).sentence, mistake.sentence)


func test_a_mistake_is_named_whichever_way_is_positive() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 15
	for kind: int in [SteppingExercise.Kind.REST, SteppingExercise.Kind.GRAVITY]:
		for question: int in 50:
			var exercise := Exercise.drawn(SteppingExercise.fresh, kind, rng)
			for mistake: Exercise.Mistake in exercise.mistakes:
				var sentence := exercise.check([-mistake.answer[0]]).sentence
				assert_false(sentence.contains("is not it yet"), exercise.prompt + sentence)
			var upside_down := exercise.check([-exercise.right_answer[0]]).sentence
			assert_false(upside_down.contains("is not it yet"), exercise.prompt + upside_down)


func _row_after(
	world: SteppedWorld, frames: int, method: SteppingMethods.Method
) -> PackedStringArray:
	var comparison := MethodComparison.new()
	comparison.begin(world)
	while comparison.frames() < frames and comparison.advance(1000, AngledLinesModel.FRAME):
		pass
	return AngledLinesTexts.comparison(comparison, method)


# A ball that touches two lines from between them.
static func _jammed() -> SteppedWorld:
	var lines: Array[Vector4] = [Vector4(-50, 5, 50, 5), Vector4(-50, -5, 50, -5)]
	return SteppedWorlds.world(lines, Ball.new(Vec2.new(), 5.0, Vec2.new(0.0, 1000.0)))


func test_week_4_puts_up_endless_lines_and_another_preset_takes_them_away() -> void:
	var model := AngledLinesModel.new()
	model.set_up(AngledLinesPresets.WEEK_4)
	assert_true(model.has_endless_lines)
	assert_eq(model.method, SteppingMethods.Method.POSITION_RESET)
	model.step()
	assert_lt(model.world.balls[1].position.y, 0.0, "a ball behind a line is put before it")
	model.set_up(3)
	assert_false(model.has_endless_lines)


func test_with_endless_lines_every_other_way_of_stepping_is_refused() -> void:
	var model := AngledLinesModel.new()
	model.set_endless_lines(true)
	for method: SteppingMethods.Method in SteppingMethods.Method.values():
		var is_known := method == SteppingMethods.Method.POSITION_RESET
		assert_eq(model.set_method(method) == "", is_known)
		assert_true(model.world.mover is EndlessLineMover)
	model.set_endless_lines(false)
	assert_no_refusal(model.set_method(SteppingMethods.Method.EVENT_WORLD))


func test_the_kind_of_line_is_kept_for_undo() -> void:
	var model := AngledLinesModel.new()
	model.set_up(AngledLinesPresets.WEEK_4)
	var stored := model.to_dictionary()
	model.set_endless_lines(false)
	model.from_dictionary(stored)
	assert_true(model.has_endless_lines)
	assert_true(model.world.mover is EndlessLineMover)
