extends LessonTest
## Drives the lesson on aiming at a target: hull, barrel and target are dragged, the barrel turns,
## the shot flies, the bug gallery.


func before_each() -> void:
	super()
	await open_lesson(LessonIndex.find(&"aim_at"))


func after_each() -> void:
	Engine.time_scale = 1.0
	await super()


func test_it_starts_with_the_angles_of_the_table() -> void:
	assert_has(formula_lines(), "γ = α + β = 30°")
	assert_has(formula_lines(), "d = (cos γ, sin γ) = (0.866, 0.5)")
	await go_to_step(AimAtModel.Step.NESTED)
	assert_has(formula_lines(), "θ = atan2(180, 0) = 90°")
	assert_has(formula_lines(), "β′ = θ − α = 60°")
	assert_reads("on the hull: 60°")


func test_hull_barrel_and_target_can_be_dragged() -> void:
	await drag(_handle("FrontHandle"), Vec2.new(-80, 0))
	assert_eq(_model().hull_degrees, 90.0)
	assert_eq(_model().barrel_degrees, 0.0, "the barrel turns with the hull")
	assert_vec2(_handle("BarrelHandle"), Vec2.new(-80, -20), 1e-9)
	await drag(_handle("BarrelHandle"), Vec2.new(0, -70))
	assert_eq(_model().barrel_degrees, -90.0)
	await drag(_handle("TargetHandle"), Vec2.new(60, 70))
	assert_vec2(_model().target, Vec2.new(60, 70), 0.0)
	await drag(_handle("HullHandle"), Vec2.new(-100, -60))
	assert_vec2(_model().hull, Vec2.new(-100, -60), 0.0)
	await click_button("Undo")
	assert_vec2(_model().hull, Vec2.new(-80, -70), 0.0)


func test_a_click_is_where_the_target_is() -> void:
	await student.click_at(place_of(Vec2.new(100, 20)))
	assert_vec2(_model().target, Vec2.new(100, 20), 0.0)


func test_the_barrel_s_own_angle_and_the_short_way_are_asked() -> void:
	await go_to_step(AimAtModel.Step.LOOK)
	await student.press(&"lab_next_step")
	assert_reads("By how much must the barrel be turned on its hull")
	await click_button("60°")
	assert_eq(frame().lesson.step, AimAtModel.Step.NESTED)
	await student.press(&"lab_next_step")
	assert_reads("Which way round is it shorter")
	await click_button("clockwise")
	assert_reads("the short way: 60° clockwise")


func test_the_barrel_turns_the_short_way_and_comes_to_rest() -> void:
	await click_button("Over 180°")
	await go_to_step(AimAtModel.Step.TURN)
	await click_button("One frame on")
	var turned := _handle("BarrelHandle").minus(_model().hull).angle_degrees()
	assert_between(turned, 135.5, 145.0, "on from 135°, over 180°")
	await play_to_end()
	turned = _handle("BarrelHandle").minus(_model().hull).angle_degrees()
	assert_almost_eq(turned, -135.0, 0.1)


func test_a_shot_that_is_fired_too_early_shows_by_how_much_it_misses() -> void:
	await go_to_step(AimAtModel.Step.EARLY)
	assert_reads("still 7.5° off")
	assert_reads("it misses by 23.5 px")
	assert_reads("from t = 0.847 s on it hits")
	await enter("seconds until it fires", "0.9")
	assert_reads("it passes within R: it hits")
	assert_false((frame().lesson.get_node("%EarlyMiss") as CanvasItem).visible)
	await play_to_end()
	var bullet := (frame().lesson.get_node("%Bullet") as ShotSprite).at()
	assert_lt(bullet.distance_to(_model().target), 10.0)


func test_the_aligned_shot_leaves_the_nozzle_and_hits() -> void:
	await go_to_step(AimAtModel.Step.FIRE)
	assert_has(formula_lines(), "N = P + L d = (−80, −20)")
	assert_reads("it hits 0.65 s after the shot")
	assert_reads("; ε × condition 1.8e−13 px")
	await click_button("One frame on")
	var bullet := (frame().lesson.get_node("%Bullet") as ShotSprite).at()
	assert_almost_eq(bullet.y, -20.0 + 200.0 / 60.0, 1e-9)
	await play_to_end()
	bullet = (frame().lesson.get_node("%Bullet") as ShotSprite).at()
	assert_vec2(bullet, Vec2.new(-80, 110), 1e-11)


func test_the_sprite_points_where_it_flies() -> void:
	await go_to_step(AimAtModel.Step.SPRITE)
	var pose := frame().lesson.get_node("%SecondPose") as ShotSprite
	assert_almost_eq(pose.degrees, Vec2.new(173.205, 220).angle_degrees(), 1e-3)
	await click_button("One frame on")
	assert_true((frame().lesson.get_node("%Bullet") as CanvasItem).visible)


func test_each_mistake_shows_its_miss() -> void:
	await pick_mistake_at(1)
	assert_eq(frame().lesson.step, AimAtModel.Step.FIRE)
	assert_reads("the mistake misses by 90 px")
	await pick_mistake_at(3)
	assert_reads("the mistake misses by 187 px")
	await pick_mistake_at(4)
	assert_eq(frame().lesson.step, AimAtModel.Step.TURN)
	assert_reads("the mistake: 270° counter-clockwise")
	await click_button("Undo")
	assert_eq(_model().mistake, AimAtMistakes.SWAPPED)


func test_wrong_numbers_are_refused() -> void:
	await enter("length of the barrel", "0")
	assert_reads("length must be within 0.001..10000, not 0.")
	assert_eq(_model().length, 50.0)
	await enter("angle of the hull", "330")
	assert_eq(_model().hull_degrees, -30.0)


func test_in_radians_angles_are_typed_and_read_in_radians() -> void:
	Conventions.choose(Conventions.Choice.RADIANS, true)
	await go_to_step(AimAtModel.Step.NESTED)
	assert_reads("on the hull: π/3")
	await enter("angle of the hull", "1.5707963267948966")
	assert_almost_eq(_model().hull_degrees, 90.0, 1e-9)


func test_the_readout_compares_the_angle_with_the_vector() -> void:
	await go_to_step(AimAtModel.Step.LOOK)
	var readout := frame().lesson.services[&"readout"] as Readout
	assert_eq(readout.cell(1, 0).text, "d by its angle")
	assert_eq(readout.cell(2, 1).text, "(0, 1)")
	assert_eq(readout.cell(2, 2).text, "0")


func _model() -> AimAtModel:
	return frame().lesson.get(&"_model")


func _handle(part: String) -> Vec2:
	return (frame().lesson.get_node("%" + part) as Handle).at()
