extends LabTest
## Where the targets of the game are, in closed form.


func test_one_that_rests_stays() -> void:
	var target := GameTarget.at(Vec2.new(30, 40))
	assert_vec2(target.place_at(17.0), Vec2.new(30, 40), 0.0)
	assert_vec2(target.velocity_at(17.0), Vec2.zero(), 0.0)


func test_one_on_a_line_goes_there_and_back() -> void:
	var target := GameTarget.between(Vec2.new(0, 0), Vec2.new(60, 80), 50)
	assert_vec2(target.place_at(1.0), Vec2.new(30, 40), 1e-12)
	assert_vec2(target.place_at(2.0), Vec2.new(60, 80), 1e-12)
	assert_vec2(target.place_at(3.0), Vec2.new(30, 40), 1e-12)
	assert_vec2(target.place_at(4.0), Vec2.zero(), 1e-12)
	assert_vec2(target.velocity_at(1.0), Vec2.new(30, 40), 1e-12)
	assert_vec2(target.velocity_at(3.0), Vec2.new(-30, -40), 1e-12)


func test_one_on_a_circle_goes_round() -> void:
	var target := GameTarget.around(Vec2.new(100, 50), 40, 20 * PI)
	assert_vec2(target.place_at(0.0), Vec2.new(140, 50), 1e-12)
	assert_vec2(target.place_at(1.0), Vec2.new(100, 90), 1e-12)
	assert_vec2(target.velocity_at(0.0), Vec2.new(0, 20 * PI), 1e-12)


func test_the_velocity_is_the_change_of_the_place() -> void:
	for target: GameTarget in [
		GameTarget.between(Vec2.new(10, 20), Vec2.new(70, -20), 35),
		GameTarget.around(Vec2.new(100, 50), 40, -60),
	]:
		for time: float in [0.3, 1.7, 5.2]:
			var change := target.place_at(time + 1e-6).minus(target.place_at(time - 1e-6))
			assert_vec2(change.scaled(0.5e6), target.velocity_at(time), 1e-3)
