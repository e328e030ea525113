extends LabTest
## The helpers of the game: which of them hit in which level.

const _MOMENTS := 40
const _BETWEEN := 0.23

## For each level the helpers with which nearly every shot hits: leads, falls, bounces.
const _RIGHT: Dictionary[int, Array] = {
	1: [false, false, false],
	2: [true, false, false],
	3: [false, true, false],
	4: [false, false, true],
	5: [false, true, false],
	6: [true, true, false],
	7: [true, false, true],
}
## Without helpers that look further than the target now, so many hit at most.
const _LUCKY := 0.3
const _NEARLY_ALL := 0.75


func test_every_level_has_helpers_that_hit() -> void:
	for number: int in GameLevel.all().size():
		var right := _RIGHT[number + 1]
		assert_gt(_share_of_hits(number, right), _NEARLY_ALL, "level %d" % (number + 1))


func test_from_the_second_level_on_aiming_at_the_present_place_misses() -> void:
	for number: int in range(1, GameLevel.all().size()):
		var share := _share_of_hits(number, [false, false, false])
		assert_lt(share, _LUCKY, "level %d" % (number + 1))


func test_levels_that_need_two_helpers_are_not_hit_with_one() -> void:
	for number: int in [5, 6]:
		for helper: int in 3:
			var one := [false, false, false]
			one[helper] = true
			assert_lt(_share_of_hits(number, one), _NEARLY_ALL, "level %d" % (number + 1))


func test_a_helper_that_finds_nothing_says_why() -> void:
	var level := GameLevel.all()[0]
	assert_eq(GameAim.of(level, 0.0, false, false, true).outcome, GameAim.Outcome.NO_WAY)
	level.target = GameTarget.between(Vec2.new(390, 0), Vec2.new(4000, -9000), 900)
	assert_eq(GameAim.of(level, 0.0, true, false, false).outcome, GameAim.Outcome.OUTRUN)
	level.gravity = Vec2.new(0, 900)
	assert_eq(GameAim.of(level, 0.0, false, true, false).outcome, GameAim.Outcome.OUT_OF_REACH)


func test_a_shot_that_will_miss_has_its_flaw() -> void:
	var wanted: Array[Array] = [
		[1, [false, false, false], GameAim.Flaw.NONE],
		[2, [false, false, false], GameAim.Flaw.MOVES_ON],
		[2, [true, false, false], GameAim.Flaw.NONE],
		[3, [false, false, false], GameAim.Flaw.FALLS],
		[3, [false, true, false], GameAim.Flaw.NONE],
		[4, [false, false, false], GameAim.Flaw.BLOCKED],
		[4, [false, false, true], GameAim.Flaw.NONE],
		[6, [true, false, false], GameAim.Flaw.FALLS],
		[7, [false, false, true], GameAim.Flaw.MOVES_ON],
		[7, [true, false, true], GameAim.Flaw.NONE],
	]
	for row: Array in wanted:
		var number: int = row[0]
		var helpers: Array = row[1]
		var flaw: GameAim.Flaw = row[2]
		assert_eq(_aim(number - 1, 0.5, helpers).flaw, flaw, str(row))
	# It goes up and turns at 4.17 s.
	assert_eq(_aim(1, 3.8, [true, false, false]).flaw, GameAim.Flaw.TURNS)


func test_a_shot_without_a_flaw_hits() -> void:
	for number: int in GameLevel.all().size():
		for moment: int in _MOMENTS:
			var now := _BETWEEN * moment
			var aim := _aim(number, now, _RIGHT[number + 1])
			if aim.hit and aim.flaw == GameAim.Flaw.NONE:
				var shot := GameShot.new(GameLevel.all()[number], aim.direction, now)
				assert_lt(shot.hit_after, INF, "level %d at %s s" % [number + 1, now])


func test_a_bullet_hits_when_the_discs_touch_and_not_before() -> void:
	var level := GameLevel.all()[0]
	var way := level.target.from.minus(level.gun)
	var shot := GameShot.new(level, way.normalized(), 0.0)
	var wanted := (way.length() - GameLevel.reach()) / GameLevel.SPEED
	assert_almost_eq(shot.hit_after, wanted, 1e-6)
	assert_false(shot.is_over(wanted - 0.01))
	assert_true(shot.is_over(wanted + 0.01))


func test_a_bullet_that_passes_tells_by_how_much() -> void:
	var level := GameLevel.all()[0]
	# Level, 150 px below the target.
	var shot := GameShot.new(level, Vec2.new(1, 0), 0.0)
	assert_eq(shot.hit_after, INF)
	assert_almost_eq(shot.nearest, 150.0, 0.5)
	assert_lt(shot.gone_after, 2.0)


func test_a_miss_knows_how_near_it_came_and_where_the_target_was_then() -> void:
	var rng := RandomNumberGenerator.new()
	rng.seed = 7
	for each: int in 70:
		var level := GameLevel.all()[each % 7]
		var now := rng.randf_range(0.0, 8.0)
		var direction := Vec2.unit_degrees(rng.randf_range(-180.0, 180.0))
		var shot := GameShot.new(level, direction, now)
		if shot.hit_after < INF:
			continue
		var place := func(seconds: float) -> Vec2: return level.target.place_at(now + seconds)
		var flight := GameShot.fired(level, direction)
		var moment := ShotSearch.nearest_moment(flight, place, shot.gone_after)
		var least := flight.distance_after(moment, place)
		assert_almost_eq(shot.nearest, least, 0.01, "%s in level %d" % [direction, each % 7 + 1])
		assert_vec2(shot.passed, level.target.place_at(now + moment), 1.0)


func test_the_way_of_a_bullet_bounces() -> void:
	var level := GameLevel.all()[3]
	var aim := GameAim.of(level, 0.0, false, false, true)
	assert_eq(GameShot.way_of(level, aim.direction, aim.time).size(), 3)


func _share_of_hits(number: int, helpers: Array) -> float:
	var level := GameLevel.all()[number]
	var hits := 0
	for moment: int in _MOMENTS:
		var now := _BETWEEN * moment
		var aim := _aim(number, now, helpers)
		if aim.hit and GameShot.new(level, aim.direction, now).hit_after < INF:
			hits += 1
	return float(hits) / _MOMENTS


func _aim(number: int, now: float, helpers: Array) -> GameAim:
	var leads: bool = helpers[0]
	var falls: bool = helpers[1]
	var bounces: bool = helpers[2]
	return GameAim.of(GameLevel.all()[number], now, leads, falls, bounces)
