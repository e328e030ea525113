extends LabTest
## The parts of a shot that are drawn: barrel and target.


func test_a_barrel_keeps_all_digits_and_spans_both_ends() -> void:
	var barrel := GunBarrel.new()
	add_child_autofree(barrel)
	barrel.lay(Vec2.new(1.0 / 3.0, 2.0), Vec2.new(5.0, 6.0))
	assert_eq(barrel.spanned_points()[0].x, 1.0 / 3.0)
	assert_eq(barrel.nozzle, Vector2(5.0, 6.0))


func test_a_target_spans_its_rim() -> void:
	var mark := TargetMark.new()
	add_child_autofree(mark)
	mark.lay(Vec2.new(10.0, 20.0), 4.0)
	assert_vec2(mark.spanned_points()[0], Vec2.new(6.0, 16.0), 0.0)
	assert_vec2(mark.spanned_points()[1], Vec2.new(14.0, 24.0), 0.0)
	assert_vec2(mark.at(), Vec2.new(10.0, 20.0), 0.0)
