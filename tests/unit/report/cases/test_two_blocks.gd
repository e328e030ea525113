extends LabTest
## Digits of pi from two blocks and a wall, and what must be kept on the way.

## How often blocks with the mass ratio 100^n meet each other and the wall, for n = 0 to 5.
const DIGITS: Array[int] = [3, 31, 314, 3141, 31415, 314159]


## The same blocks, one impact at a time, written for reading. The loop of [method TwoBlocks.run]
## is compared with it.
class ReadableBlocks:
	var mass_ratio: float
	var time := 0.0
	var light_x := TwoBlocks.LIGHT_START
	var light_velocity := 0.0
	var heavy_x := TwoBlocks.HEAVY_START
	var heavy_velocity := TwoBlocks.HEAVY_SPEED
	var impacts := 0

	func _init(ratio: float) -> void:
		mass_ratio = ratio

	func advance_to_next_impact() -> void:
		var approach := light_velocity - heavy_velocity
		var to_block := (heavy_x - light_x) / approach if approach > 0.0 else INF
		var to_wall := light_x / -light_velocity if light_velocity < 0.0 else INF
		if to_block < to_wall:
			_move(to_block)
			light_x = heavy_x
			heavy_velocity += approach * (2.0 / (1.0 + mass_ratio))
			light_velocity = heavy_velocity - approach
		elif to_wall < INF:
			_move(to_wall)
			light_x = 0.0
			light_velocity = -light_velocity

	func _move(seconds: float) -> void:
		time += seconds
		light_x += light_velocity * seconds
		heavy_x += heavy_velocity * seconds
		impacts += 1


func test_the_impacts_spell_the_digits_of_pi() -> void:
	for n: int in DIGITS.size():
		assert_eq(_finished(100.0 ** n).impacts, DIGITS[n], "n = %d" % n)


func test_mass_ratios_that_are_no_power_of_100_give_the_number_of_angles_in_pi() -> void:
	for ratio: float in [1e-12, 0.3, 2.0, 7.0, 1234.5, 3e7]:
		var angle := atan(1.0 / sqrt(ratio))
		assert_eq(_finished(ratio).impacts, ceili(PI / angle) - 1, "mass ratio %s" % ratio)


func test_the_energy_is_kept() -> void:
	var drifts := PackedFloat64Array()
	for n: int in DIGITS.size():
		drifts.append(absf(_finished(100.0 ** n).energy_drift()))
	assert_all_at_most(drifts, 1e-13)


func test_a_wrong_energy_would_be_seen() -> void:
	var blocks := _finished(100.0)
	blocks.heavy_velocity *= 1.01
	assert_almost_eq(blocks.energy_drift(), 0.02, 0.001)


func test_the_heavy_block_ends_as_fast_as_the_turned_velocity_says() -> void:
	for ratio: float in [1.0, 100.0, 777.0]:
		# In coordinates times the root of the mass, an impact of the blocks and the next one of
		# the wall together turn the velocity by 2 atan(1 / sqrt(ratio)).
		var blocks := _finished(ratio)
		var meetings := ceilf(blocks.impacts / 2.0)
		var turned := meetings * 2.0 * atan(1.0 / sqrt(ratio))
		assert_almost_eq(blocks.heavy_velocity, TwoBlocks.HEAVY_SPEED * cos(turned), 1e-10)


func test_places_and_time_belong_together_all_the_way() -> void:
	var blocks := TwoBlocks.new()
	assert_eq(blocks.start(1e4), "")
	var errors := PackedFloat64Array()
	while blocks.run(1):
		errors.append(absf(_distance_squared(blocks) / _straight_distance_squared(blocks) - 1.0))
	assert_eq(errors.size(), 314)
	assert_all_at_most(errors, 1e-9)


func test_the_tight_loop_makes_the_same_steps_to_the_last_bit() -> void:
	var quick := TwoBlocks.new()
	var readable := ReadableBlocks.new(1e6)
	assert_eq(quick.start(1e6), "")
	var is_going_on := true
	while is_going_on:
		is_going_on = quick.run(100)
		for _impact: int in 100:
			readable.advance_to_next_impact()
		assert_eq(_state(quick), _readable_state(readable))


func test_it_stops_after_as_many_impacts_as_it_was_told() -> void:
	var blocks := TwoBlocks.new()
	assert_eq(blocks.start(100.0), "")
	assert_true(blocks.run(30))
	assert_eq(blocks.impacts, 30)
	assert_false(blocks.run(30))
	assert_eq(blocks.impacts, 31)


func test_a_mass_ratio_that_is_none_is_refused_and_nothing_changes() -> void:
	var blocks := _finished(100.0)
	for ratio: float in [0.0, -1.0, NAN, INF, 1e17]:
		assert_eq(
			blocks.start(ratio), "The mass ratio must be above 0 and at most 1e16, not %s." % ratio
		)
	assert_eq([blocks.impacts, blocks.mass_ratio], [31, 100.0])


func _finished(ratio: float) -> TwoBlocks:
	var blocks := TwoBlocks.new()
	assert_eq(blocks.start(ratio), "")
	while blocks.run(1000):
		pass
	return blocks


# In coordinates times the root of the mass, both blocks are one point in a corner. When every
# impact is unfolded it moves on straight. This is the square of its distance from the corner ...
func _distance_squared(blocks: TwoBlocks) -> float:
	return blocks.mass_ratio * blocks.heavy_x ** 2 + blocks.light_x ** 2


# ... and this is the same on the straight line.
func _straight_distance_squared(blocks: TwoBlocks) -> float:
	var heavy := TwoBlocks.HEAVY_START + TwoBlocks.HEAVY_SPEED * blocks.time
	return blocks.mass_ratio * heavy ** 2 + TwoBlocks.LIGHT_START ** 2


func _state(blocks: TwoBlocks) -> PackedFloat64Array:
	return [
		blocks.light_x,
		blocks.light_velocity,
		blocks.heavy_x,
		blocks.heavy_velocity,
		blocks.time,
		blocks.impacts
	]


func _readable_state(blocks: ReadableBlocks) -> PackedFloat64Array:
	return [
		blocks.light_x,
		blocks.light_velocity,
		blocks.heavy_x,
		blocks.heavy_velocity,
		blocks.time,
		blocks.impacts
	]
