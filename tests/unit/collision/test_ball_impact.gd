extends LabTest
## The exact impact of two balls, against 2000 answers that were computed with 60 digits.

const _TIME_BOUND := 4.0
const _NORMAL_BOUND := 4.0
const _VELOCITY_BOUND := 8.0

var _table := ImpactTable.new("ball_ball")


func test_hit_or_miss_agrees_in_every_row() -> void:
	var wrong := PackedInt32Array()
	for row: int in _table.size():
		if _impact(row).hit != _table.is_hit(row):
			wrong.append(row)
	assert_eq(wrong, PackedInt32Array())


func test_time_normal_and_velocities_are_right_to_the_last_bits() -> void:
	var times := WorstErrors.new()
	var normals := WorstErrors.new()
	var velocities := WorstErrors.new()
	for row: int in _table.size():
		var impact := _impact(row)
		if impact.hit and _table.is_hit(row):
			times.note(_table.family(row), _table.time_error(row, impact.time))
			normals.note(_table.family(row), _normal_error(row, impact))
			velocities.note(_table.family(row), _velocity_error(row, impact))
	gut.p("worst error of the time, two balls: %s" % times)
	gut.p("worst error of the normal, two balls: %s" % normals)
	gut.p("worst error of the velocities after, two balls: %s" % velocities)
	assert_all_at_most(times.values(), _TIME_BOUND)
	assert_all_at_most(normals.values(), _NORMAL_BOUND)
	assert_all_at_most(velocities.values(), _VELOCITY_BOUND)


func test_the_plain_time_is_as_good() -> void:
	var times := WorstErrors.new()
	var finder := StraightImpactFinder.new()
	for row: int in _table.size():
		var one := _ball(row, "1")
		var other := _ball(row, "2")
		var place := one.position.minus(other.position)
		var velocity := one.velocity.minus(other.velocity)
		var reach := one.radius + other.radius
		var is_hit := finder.with_point(place.x, place.y, velocity.x, velocity.y, reach, 0, 0)
		times.note(_table.family(row), INF if is_hit != _table.is_hit(row) else 0.0)
		if is_hit:
			times.note(_table.family(row), _table.time_error(row, finder.time))
	assert_all_at_most(times.values(), _TIME_BOUND)


func test_the_velocities_agree_with_the_bounce_of_the_slides() -> void:
	var one := Ball.new(Vec2.new(-50, 3), 10, Vec2.new(120, 0), 2)
	var other := Ball.new(Vec2.new(40, 0), 15, Vec2.new(-80, 5), 3)
	var impact := BallImpact.between(one, other, 0.6)
	BallBounce.apply(one, other, impact.normal, 0.6)
	assert_vec2(impact.velocity_one, one.velocity, 1e-13)
	assert_vec2(impact.velocity_other, other.velocity, 1e-13)


func test_balls_that_move_apart_do_not_meet() -> void:
	var one := Ball.new(Vec2.new(15, 0), 10, Vec2.new(1, 0))
	assert_false(BallImpact.between(one, Ball.new(Vec2.zero(), 10)).hit)


func test_the_balls_stay_as_they_are() -> void:
	var one := Ball.new(Vec2.new(50, 0), 10, Vec2.new(-1, 0))
	assert_true(BallImpact.between(one, Ball.new(Vec2.zero(), 10)).hit)
	assert_vec2(one.velocity, Vec2.new(-1, 0), 0.0)


func _impact(row: int) -> BallImpact:
	return BallImpact.between(_ball(row, "1"), _ball(row, "2"), _table.at(row, "restitution"))


func _ball(row: int, number: String) -> Ball:
	var place := Vec2.new(_table.at(row, "p%sx" % number), _table.at(row, "p%sy" % number))
	var velocity := Vec2.new(_table.at(row, "v%sx" % number), _table.at(row, "v%sy" % number))
	return Ball.new(place, _table.at(row, "r" + number), velocity, _table.at(row, "m" + number))


func _normal_error(row: int, impact: BallImpact) -> float:
	var one := _ball(row, "1")
	var other := _ball(row, "2")
	var lengths: PackedFloat64Array = [
		one.velocity.minus(other.velocity).length(),
		one.position.length(),
		other.position.length(),
	]
	return _table.normal_error(row, impact.normal, one.radius + other.radius, lengths)


# The error in units of EPSILON times the larger velocity after the impact.
func _velocity_error(row: int, impact: BallImpact) -> float:
	var one := Vec2.new(_table.at(row, "v1x_after"), _table.at(row, "v1y_after"))
	var other := Vec2.new(_table.at(row, "v2x_after"), _table.at(row, "v2y_after"))
	var error := maxf(
		one.distance_to(impact.velocity_one), other.distance_to(impact.velocity_other)
	)
	var larger := maxf(one.length(), other.length())
	return error / (EPSILON * larger) if error > 0.0 else 0.0
